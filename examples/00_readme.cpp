// SPDX-License-Identifier: MIT
#include <polydec.h>

int main() {
    const auto fandisk = polydec::discretize(polydec::read_mesh("fandisk.off"));
    const auto modes = polydec::spectrum({fandisk, polydec::Side::dual, 0}, {.count = 20});
    polydec::write_page("modes.html", polydec::draw_page(fandisk, modes));
}
