# SPDX-License-Identifier: MIT
"""Flaws of backends/; see mutate.py."""

MUTANTS = {
    "groups_as_if_orthogonal": ("backends/spectra/found_pairs.cpp",
                                "                others_[i] += share;\n                others_[j] += share;\n", "",
                                "KeptSpectra.are_right_whatever_they_are_begun_with"),
    "zeros_searched": ("backends/spectra/found_pairs.cpp", "    pairs.take(Y, pencil.enclose(Y));", "",
                       "SpectraOfManyPieces.have_a_zero_for_each_and_for_each_hole"),
    "factor_whatever_its_size": ("backends/linear/checked_solver.cpp", "if (!lack.empty())", "if (false)",
                                 "checked_solver.factors_that_exceed_the_limit_are_refused"),
    "factor_after_factor": ("backends/linear/auto_solver.cpp", "if (lacks_memory_ && engine_", "if (false && engine_",
                            "auto_solver.factors_beyond_the_memory_limit_leave_the_work_to_an_iterative_engine"),
    "midpoint_out_of_the_middle": ("backends/integrators/additive_table.cpp",
                                   "one_stage(2, 0.5)", "one_stage(2, 0.45)",
                                   "Robin.lets_heat_fade_as_its_closed_form"),
    "plan_forgotten_between_frames": ("backends/integrators/runge_kutta.cpp",
                                      "if (until != end_ || !is_fixed())", "if (true)",
                                      "engines/StepsOfOneLength.go_on_in_the_same_bits_from_between_two_times/runge_kutta"),
    "last_stage_is_no_end": ("backends/integrators/runge_kutta.cpp",
                             "Vector next = is_end ? stage_ : state()",
                             "Vector next = state()",
                             "engines/IntegratorContract.fixed_steps_have_the_order_of_the_engine/runge_kutta"),
    "engine_of_no_factor": ("backends/spectra/shifted_solver.cpp", "    used_ = engine();\n", "",
                            "ShiftedSolver.solves_alike_after_it_made_room"),
    "inertia_hidden": ("backends/spectra/inertia.cpp", "return *negative - matrices_.hidden;",
                       "return *negative - matrices_.hidden + 1;",
                       "PeriodicBox.has_the_eigenvalues_of_plane_waves"),
}
