// SPDX-License-Identifier: MIT
#include "tests/backends/matrices.h"

#include <sys/resource.h>
#include <unistd.h>

namespace polydec::test::in_engine_module {

TEST(engine_module, a_module_registers_its_engines_once) {
    EXPECT_FALSE(has_linear_solver("module.llt"));
    load_engine_module(POLYDEC_TEST_GOOD_MODULE);
    load_engine_module(POLYDEC_TEST_GOOD_MODULE);
    ASSERT_TRUE(has_linear_solver("module.llt"));

    const auto solver = make_linear_solver("module.llt");
    const auto A = grid_laplacian(6);
    const DenseMatrix B = random_matrix(36, 2, 1);
    solver->factorize(A, positive());
    EXPECT_PRED3(solves, A, solver->solve(B), B);
    EXPECT_EQ(solver->report().engine, "module.llt");
}

TEST(engine_module, errors_cross_the_border_of_a_module) {
    load_engine_module(POLYDEC_TEST_GOOD_MODULE);
    const auto solver = make_linear_solver("module.llt");
    EXPECT_THROW(solver->factorize(grid_laplacian(3), general()), InvalidInput);
    EXPECT_THROW(solver->factorize(shifted(grid_laplacian(3), 9.0), positive()), SolverFailure);
}

TEST(engine_module, a_module_for_another_version_is_refused_before_it_runs) {
    const std::string path = POLYDEC_TEST_OLD_MODULE;
    EXPECT_ERROR(BackendUnavailable, load_engine_module(path), path, "version 0",
                 std::to_string(engine_module_version));
}

TEST(engine_module, engines_that_a_refused_file_registered_as_it_was_loaded_stay_in_use) {
    EXPECT_THROW(load_engine_module(POLYDEC_TEST_OLD_MODULE), BackendUnavailable);
    const auto solver = make_linear_solver("registered-as-loaded");
    const auto A = grid_laplacian(6);
    const DenseMatrix B = random_matrix(36, 2, 1);
    solver->factorize(A, positive());
    EXPECT_PRED3(solves, A, solver->solve(B), B);
}

TEST(engine_module, what_is_no_module_is_refused) {
    EXPECT_THROW(load_engine_module("/nowhere/module.so"), IoError);
    EXPECT_THROW(load_engine_module("."), IoError);
    EXPECT_THROW(load_engine_module(POLYDEC_TEST_FILES "/golden/uv8.off"), IoError);
    const auto message =
        message_of<IoError>([] { load_engine_module("/lib/x86_64-linux-gnu/libm.so.6"); });
    EXPECT_NE(message.find("libm.so.6"), std::string::npos);
}

/// A folder of engines with one module that is none, until the end of a test.
class BrokenModule {
public:
    explicit BrokenModule(const std::string& name) {
        std::ofstream(folder_ / (name + ".so")) << "no shared library";
        setenv("POLYDEC_ENGINES", folder_.c_str(), 1);
    }
    ~BrokenModule() {
        if (before_)
            setenv("POLYDEC_ENGINES", before_->c_str(), 1);
        else
            unsetenv("POLYDEC_ENGINES");
        std::filesystem::remove_all(folder_);
    }

private:
    static std::filesystem::path make_folder() {
        std::string pattern = std::filesystem::temp_directory_path() / "polydec-engines-XXXXXX";
        return mkdtemp(pattern.data());
    }
    static std::optional<std::string> now() {
        const char* value = std::getenv("POLYDEC_ENGINES");
        return value ? std::optional<std::string>(value) : std::nullopt;
    }

    std::filesystem::path folder_ = make_folder();
    std::optional<std::string> before_ = now();
};

TEST(engine_module, why_a_module_cannot_be_loaded_is_told_when_its_engine_is_asked_for) {
    const BrokenModule module("broken");
    EXPECT_FALSE(has_linear_solver("broken.solver"));
    const auto message =
        message_of<BackendUnavailable>([] { make_linear_solver("broken.solver"); });
    EXPECT_SAYS(message, "linear solver", "broken.solver");
    EXPECT_SAYS(message, "broken.so", "module");
    EXPECT_THROW(make_linear_solver("unbroken.solver"), InvalidInput);
}

// The system's loader would end the program.
TEST(engine_module, no_module_is_loaded_where_address_space_is_short) {
    const auto load_in_little_space = [] {
        rlim_t pages = 0;
        std::ifstream("/proc/self/statm") >> pages;
        rlimit limit{};
        getrlimit(RLIMIT_AS, &limit);
        limit.rlim_cur = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + (rlim_t{200} << 20);
        setrlimit(RLIMIT_AS, &limit);
        try {
            load_engine_module(POLYDEC_TEST_GOOD_MODULE);
        } catch (const BackendUnavailable& failure) {
            const std::string message = failure.what();
            _exit(message.find("a module may need 256 MB") != std::string::npos ? 0 : 2);
        }
        _exit(1);
    };
    EXPECT_EXIT(load_in_little_space(), testing::ExitedWithCode(0), "");
}

} // namespace polydec::test::in_engine_module
