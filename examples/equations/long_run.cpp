// SPDX-License-Identifier: MIT
//
// A long run that may be killed at any time. After a restart it resumes from its last checkpoint,
// with bitwise identical results.
#include <filesystem>
#include <iostream>
#include <polydec.h>

void run(const std::vector<double>& times) {
    const auto sphere = polydec::discretize(polydec::goldberg(8));
    const polydec::Cochain z{polydec::Side::primal, 0, sphere.points().col(2)};
    polydec::Evolution heat(
        {{.space = {sphere, polydec::Side::primal, 0}, .start = z.values, .diffusion = 1}});
    const auto show = [&](const polydec::Run& now) {
        const double left = polydec::norm(sphere, now.form(0)) / polydec::norm(sphere, z);
        std::cout << "at " << now.time() << " there is " << left << '\n';
    };
    polydec::march(heat, times, {.checkpoint = "run.checkpoint", .show = show});
}

int main() {
    std::filesystem::remove("run.checkpoint");
    run({0.1, 0.2}); // and is killed
    run({0.1, 0.2, 0.3, 0.4});
}
