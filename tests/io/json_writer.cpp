// SPDX-License-Identifier: MIT
#include "io/json_writer.h"

#include "tests/support/test.h"

namespace polydec::test::in_json_writer {

template <class Value>
std::string text_of(const Value& value) {
    JsonWriter json;
    json.value(value);
    return std::string(json.view());
}

TEST(JsonWriter, WritesEveryKindOfValue) {
    JsonWriter json;
    json.object([&] {
        json.member("truth", true);
        json.member("count", std::int64_t{-7000000000});
        json.member("number", 0.1);
        json.member("text", "a \"word\"\n");
        json.member("none", std::optional<double>());
        json.member("some", std::optional<int>(3));
        json.member("list", std::vector<double>{1, 2.5});
        json.member("vector", Vector::LinSpaced(3, 0, 1).eval());
        json.array("lists", [&] {
            json.value(std::vector<int>{});
            json.array([&] { json.value(std::vector<std::string>{"a", "b"}); });
        });
        json.object("inner", [&] { json.member("key", 1); });
    });
    EXPECT_EQ(json.view(), R"({"truth":true,"count":-7000000000,"number":0.1,)"
                           R"("text":"a \"word\"\n","none":null,"some":3,"list":[1.0,2.5],)"
                           R"("vector":[0.0,0.5,1.0],"lists":[[],[["a","b"]]],)"
                           R"("inner":{"key":1}})");
}

TEST(JsonWriter, NumbersReadBackToTheLastBit) {
    std::uint64_t bits = 1;
    for (int i = 0; i < 100000; ++i) {
        bits = bits * 6364136223846793005U + 1442695040888963407U;
        double value = 0;
        std::memcpy(&value, &bits, sizeof value);
        if (std::isfinite(value)) {
            ASSERT_EQ(nlohmann::json::parse(text_of(value)).get<double>(), value);
        }
    }
}

TEST(JsonWriter, NumbersThatAreNoneAreRefusedByName) {
    for (const double value :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        JsonWriter json;
        try {
            json.object([&] { json.member("residual", value); });
            FAIL();
        } catch (const SolverFailure& error) {
            EXPECT_SAYS(error.what(), "residual", "finite");
        }
    }
}

TEST(JsonWriter, TextIsValidUtf8Always) {
    for (const std::string text : {"größe", "a\xff\xfe.off", "\x1b", ""})
        EXPECT_TRUE(nlohmann::json::accept(text_of(text))) << text;
    EXPECT_EQ(text_of("a\xff"), R"("a\\xff")");
}

} // namespace polydec::test::in_json_writer
