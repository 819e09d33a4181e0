// SPDX-License-Identifier: MIT
#include "tests/fuzz/targets.h"
#include "tests/support/test.h"

namespace polydec::fuzz {

namespace {

namespace fs = std::filesystem;

std::string bytes_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// The files of a target's corpus, and what each broke; sorted, so that a failure is found again.
std::vector<std::string> findings(const Target& target) {
    std::vector<std::string> result;
    for (const auto& file : fs::directory_iterator(fs::path(POLYDEC_FUZZ_CORPUS) / target.name)) {
        try {
            target.run(bytes_of(file.path()));
        } catch (const std::exception& error) {
            result.push_back(file.path().filename().string() + ": " + error.what());
        }
    }
    std::sort(result.begin(), result.end());
    return result;
}

std::set<std::string> names_of_targets() {
    std::set<std::string> names;
    for (const auto& target : targets)
        names.insert(std::string(target.name));
    return names;
}

} // namespace

TEST(Fuzz, EveryTargetIsAProgramAndHasACorpus) {
    std::istringstream list(POLYDEC_FUZZ_TARGETS);
    const std::set<std::string> programs{std::istream_iterator<std::string>(list), {}};
    EXPECT_EQ(programs, names_of_targets());
    std::set<std::string> folders;
    for (const auto& folder : fs::directory_iterator(POLYDEC_FUZZ_CORPUS))
        folders.insert(folder.path().filename().string());
    EXPECT_EQ(folders, names_of_targets());
}

class Corpus : public testing::TestWithParam<Target> {};

TEST_P(Corpus, BreaksNoPromise) {
    EXPECT_EQ(findings(GetParam()), std::vector<std::string>());
}

INSTANTIATE_TEST_SUITE_P(Fuzz, Corpus, testing::ValuesIn(targets),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(Fuzz, ABrokenPromiseIsAFinding) {
    const Target broken{"off", [](std::string_view bytes) {
                            require(bytes.substr(0, 3) != "OFF", "no file begins with OFF");
                        }};
    EXPECT_GT(findings(broken).size(), 1U);
    EXPECT_THROW(require_message("bell\a"), Finding);
    EXPECT_THROW(require_message(std::string(2000, 'x')), Finding);
    EXPECT_THROW(require_message(""), Finding);
    EXPECT_THROW(accepts([] { throw SolverFailure("no refusal"); }), SolverFailure);
}

} // namespace polydec::fuzz
