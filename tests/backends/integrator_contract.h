// SPDX-License-Identifier: MIT
#pragma once

#include "tests/backends/matrices.h"

/// Problems that integrators are tested on, and what is asked of each.
namespace polydec::test::in_integrator_contract {

/// u' = L u + q(t) - L p(t) with p' = q has the solution p, whatever the stiffness of L = -lambda
/// is; p is (cos t, sin 2t, ..) for any size.
struct Forced {
    double stiffness = 1;
    Index size = 4;

    Vector exact(double t) const {
        return Vector::NullaryExpr(size, [&](Eigen::Index i) { return std::cos((i + 1) * t + i); });
    }
    Vector slope(double t) const {
        return Vector::NullaryExpr(
            size, [&](Eigen::Index i) { return -(i + 1) * std::sin((i + 1) * t + i); });
    }
    Vector lambda() const { return stiffness * Vector::LinSpaced(size, 0.5, 1); }

    /// -lambda (u - p) as the stiff part.
    StiffPart decay() const {
        const auto gamma = std::make_shared<double>(0);
        return {.rate =
                    [*this](double t, const Vector& y) {
                        return Vector(lambda().cwiseProduct(exact(t) - y));
                    },
                .prepare = [gamma](double, const Vector&, double value) { *gamma = value; },
                .solve =
                    [*this, gamma](const Vector& b) {
                        return Vector(b.array() / (1 + *gamma * lambda().array()));
                    }};
    }

    InitialValueProblem split() const {
        return {.rate = [*this](double t, const Vector&) { return slope(t); }, .stiff = decay()};
    }

    /// All of it in one of the parts.
    InitialValueProblem stiff_alone() const {
        auto stiff = decay();
        stiff.rate = [*this](double t, const Vector& y) {
            return Vector(slope(t) + lambda().cwiseProduct(exact(t) - y));
        };
        return {.stiff = std::move(stiff)};
    }
    InitialValueProblem mild_alone() const {
        return {.rate = [*this](double t, const Vector& y) {
            return Vector(slope(t) + lambda().cwiseProduct(exact(t) - y));
        }};
    }
};

/// A rotation that grows and shrinks: u' = (cos t + i) u.
inline InitialValueProblem swinging() {
    return {.rate = [](double t, const Vector& y) {
        return Vector{{std::cos(t) * y[0] - y[1], std::cos(t) * y[1] + y[0]}};
    }};
}
inline Vector swung(double t) {
    return std::exp(std::sin(t)) * Vector{{std::cos(t), std::sin(t)}};
}

/// The cube root of its forcing: u' = p' - k (u^3 - p^3), stiff and nonlinear, with p = 2 + sin t.
inline InitialValueProblem cubic(double k) {
    const auto p = [](double t) { return 2 + std::sin(t); };
    const auto weight = std::make_shared<double>(0);
    StiffPart stiff{.rate =
                        [=](double t, const Vector& y) {
                            return Vector{{-k * (std::pow(y[0], 3) - std::pow(p(t), 3))}};
                        },
                    .prepare = [=](double, const Vector& y,
                                   double gamma) { *weight = 1 + gamma * 3 * k * y[0] * y[0]; },
                    .solve = [=](const Vector& b) { return Vector(b / *weight); },
                    .linearity = Linearity::general};
    return {.rate = [](double t, const Vector&) { return Vector{{std::cos(t)}}; },
            .stiff = std::move(stiff)};
}

/// Engines that take steps of one length alone, and their orders.
inline const std::map<std::string, double> of_one_length{{"backward-euler", 1},
                                                         {"implicit-midpoint", 2}};

inline std::vector<std::string> names_of_those_that_choose() {
    auto names = integrator_engine_names();
    std::erase_if(names, [](const auto& name) { return of_one_length.contains(name); });
    return names;
}

/// What every integrator promises that chooses its steps, whichever it is.
class IntegratorContract : public testing::TestWithParam<std::string> {
protected:
    std::unique_ptr<Integrator> make(const IntegratorOptions& options = {}) const {
        return make_integrator(GetParam(), options);
    }

    std::unique_ptr<Integrator> begun(const InitialValueProblem& problem, const Vector& state,
                                      const IntegratorOptions& options = {}) const {
        auto result = make(options);
        result->begin(problem, 0, state);
        return result;
    }

    /// Of the error at the end of a march by fixed steps, when these are halved.
    double order(const InitialValueProblem& problem, const Vector& begin, const Vector& end,
                 double until, Index steps) const {
        const auto error = [&](Index count) {
            const auto run =
                begun(problem, begin, {.absolute_tolerance = 1e-13, .fixed_step = until / count});
            run->advance(until);
            EXPECT_EQ(run->report().steps, count);
            return (run->state() - end).norm();
        };
        return std::log2(error(steps) / error(2 * steps));
    }
};

} // namespace polydec::test::in_integrator_contract
