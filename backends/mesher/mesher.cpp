// SPDX-License-Identifier: MIT
#include "backends/mesher.h"

#include "backends/mesher/mesher_input.h"
#include "backends/mesher/mesher_output.h"
#include "backends/registry.h"

namespace polydec {

MesherOutput tetrahedralize(const MesherInput& input, const MesherOptions& options,
                            const std::string& engine) {
    const Mesher mesher = find_mesher(engine);
    check_mesher_options(options);
    check_mesher_input(input);
    auto output = mesher(input, options);
    check_mesher_output(input, engine, output);
    return output;
}

} // namespace polydec
