// SPDX-License-Identifier: MIT
#include "io/checkpoint.h"
#include "python/bindings/convert.h"

namespace polydec::python {

void add_checkpoints(py::module_& module) {
    py::class_<Fingerprint>(module, "Fingerprint")
        .def(py::init<>())
        .def("add_text", [](Fingerprint& self, const std::string& text) { self.add(text); })
        .def("add_number", [](Fingerprint& self, double number) { self.add(number); })
        .def("add_numbers",
             [](Fingerprint& self, const Numbers& numbers) { self.add(vector(numbers)); })
        .def("add_mesh", [](Fingerprint& self,
                            const Discretization& mesh) { unlocked([&] { self.add(mesh); }); })
        .def("value", &Fingerprint::value);
    module.def("write_checkpoint",
               [](const std::string& path, std::uint64_t problem, std::uint64_t step, double time,
                  const std::vector<Numbers>& state) {
                   const Checkpoint checkpoint{problem, step, time, vectors(state)};
                   unlocked([&] { write_checkpoint(path, checkpoint); });
               });
    module.def("read_checkpoint", [](const std::string& path, std::uint64_t problem) {
        Checkpoint found = unlocked([&] { return read_checkpoint(path, problem); });
        return py::make_tuple(found.step, found.time, arrays(std::move(found.state)));
    });
}

} // namespace polydec::python
