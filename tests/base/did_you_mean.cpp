// SPDX-License-Identifier: MIT
#include "base/did_you_mean.h"

#include "tests/support/test.h"

namespace polydec {
namespace {

const std::vector<std::string> commands{"info", "merge", "heat", "wave", "spectrum", "--side"};

TEST(DidYouMean, NamesTheKnownNameThatTakesTheFewestEdits) {
    EXPECT_EQ(did_you_mean("haet", commands), ": did you mean 'heat'?");     // swapped
    EXPECT_EQ(did_you_mean("hea", commands), ": did you mean 'heat'?");      // left out
    EXPECT_EQ(did_you_mean("mergen", commands), ": did you mean 'merge'?");  // inserted
    EXPECT_EQ(did_you_mean("wafe", commands), ": did you mean 'wave'?");     // replaced
    EXPECT_EQ(did_you_mean("--sied", commands), ": did you mean '--side'?"); // of two, the nearer
}

TEST(DidYouMean, AllowsTwoEditsOrAThirdOfTheLength) {
    EXPECT_EQ(did_you_mean("heatxx", commands), ": did you mean 'heat'?");
    EXPECT_EQ(did_you_mean("heatxxx", commands), "");
    EXPECT_EQ(did_you_mean("spectrumxxxx", commands), ": did you mean 'spectrum'?");
    EXPECT_EQ(did_you_mean("spectrumxxxxx", commands), "");
}

TEST(DidYouMean, NamesNothingThatSharesNoLetter) {
    EXPECT_EQ(did_you_mean("xy", {"ab"}), "");
    EXPECT_EQ(did_you_mean("", commands), "");
    EXPECT_EQ(did_you_mean("heat", {}), "");
    EXPECT_EQ(did_you_mean(std::string(100'000, 'x'), commands), "");
}

TEST(DidYouMean, TakesTheFirstOfNamesThatAreEquallyNear) {
    EXPECT_EQ(did_you_mean("ac", {"ab", "bc"}), ": did you mean 'ab'?");
}

} // namespace
} // namespace polydec
