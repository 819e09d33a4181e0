// SPDX-License-Identifier: MIT
#include "backends/integrators/additive_table.h"

namespace polydec {

AdditiveTable dormand_prince() {
    AdditiveTable t{.order = 5, .embedded_order = 4};
    t.times = Vector{{0, 1. / 5, 3. / 10, 4. / 5, 8. / 9, 1, 1}};
    t.weights = Vector{{35. / 384, 0, 500. / 1113, 125. / 192, -2187. / 6784, 11. / 84, 0}};
    t.explicit_part = DenseMatrix::Zero(7, 7);
    auto& E = t.explicit_part;
    E.row(1).head(1) << 1. / 5;
    E.row(2).head(2) << 3. / 40, 9. / 40;
    E.row(3).head(3) << 44. / 45, -56. / 15, 32. / 9;
    E.row(4).head(4) << 19372. / 6561, -25360. / 2187, 64448. / 6561, -212. / 729;
    E.row(5).head(5) << 9017. / 3168, -355. / 33, 46732. / 5247, 49. / 176, -5103. / 18656;
    E.row(6) = t.weights.transpose();
    const Vector embedded{
        {5179. / 57600, 0, 7571. / 16695, 393. / 640, -92097. / 339200, 187. / 2100, 1. / 40}};
    t.error_weights = t.weights - embedded;
    return t;
}

AdditiveTable kennedy_carpenter() {
    AdditiveTable t{.order = 4, .embedded_order = 3};
    t.times = Vector{{0, 1. / 2, 83. / 250, 31. / 50, 17. / 20, 1}};
    t.weights =
        Vector{{82889. / 524892, 0, 15625. / 83664, 69875. / 102672, -2260. / 8211, 1. / 4}};
    t.explicit_part = DenseMatrix::Zero(6, 6);
    auto& E = t.explicit_part;
    E.row(1).head(1) << 1. / 2;
    E.row(2).head(2) << 13861. / 62500, 6889. / 62500;
    E.row(3).head(3) << -116923316275. / 2393684061468, -2731218467317. / 15368042101831,
        9408046702089. / 11113171139209;
    E.row(4).head(4) << -451086348788. / 2902428689909, -2682348792572. / 7519795681897,
        12662868775082. / 11960479115383, 3355817975965. / 11060851509271;
    E.row(5).head(5) << 647845179188. / 3216320057751, 73281519250. / 8382639484533,
        552539513391. / 3454668386233, 3354512671639. / 8306763924573, 4040. / 17871;
    t.implicit_part = DenseMatrix::Zero(6, 6);
    auto& I = t.implicit_part;
    I.diagonal().tail(5).setConstant(1. / 4);
    I.row(1).head(1) << 1. / 4;
    I.row(2).head(2) << 8611. / 62500, -1743. / 31250;
    I.row(3).head(3) << 5012029. / 34652500, -654441. / 2922500, 174375. / 388108;
    I.row(4).head(4) << 15267082809. / 155376265600, -71443401. / 120774400, 730878875. / 902184768,
        2285395. / 8070912;
    I.row(5) = t.weights.transpose();
    const Vector embedded{{4586570599. / 29645900160, 0, 178811875. / 945068544,
                           814220225. / 1159782912, -3700637. / 11593932, 61727. / 225920}};
    t.error_weights = t.weights - embedded;
    return t;
}

namespace {

/// One implicit stage at a part c of the step, whose rates are those of the step.
AdditiveTable one_stage(int order, double c) {
    return {.order = order,
            .times = Vector{{0, c}},
            .explicit_part = DenseMatrix{{0, 0}, {c, 0}},
            .implicit_part = DenseMatrix{{0, 0}, {0, c}},
            .weights = Vector{{0, 1}},
            .error_weights = Vector::Zero(2)};
}

} // namespace

AdditiveTable backward_euler() {
    return one_stage(1, 1);
}

AdditiveTable implicit_midpoint() {
    return one_stage(2, 0.5);
}

bool AdditiveTable::ends_at_last_stage(bool has_f, bool has_g) const {
    const auto last = [&](const DenseMatrix& part) {
        return part.rows() > 0 && part.row(part.rows() - 1) == weights.transpose();
    };
    return (!has_f || last(explicit_part)) && (!has_g || last(implicit_part));
}

bool AdditiveTable::uses_first_stiff_rate() const {
    return implicit_part.size() > 0 && (!implicit_part.col(0).isZero(0) || weights[0] != 0);
}

} // namespace polydec
