// SPDX-License-Identifier: MIT
#include <polydec.h>

int main() {
    const auto part = polydec::discretize(polydec::read_mesh("part.off"));
    const auto modes = polydec::spectrum({part, polydec::Side::dual, 0}, {.count = 20});
    polydec::write_page("modes.html", polydec::draw_page(part, modes));
}
