// The numbers of text files against the standard library, bit by bit.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string>

#include "base/random.h"
#include "io/text.h"

namespace plateau {
namespace {

bool same_bits(double a, double b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

void expect_as_the_library(const std::string& field) {
    char* end = nullptr;
    const double value = std::strtod(field.c_str(), &end);
    const ParsedField parsed = parse_field(field);
    if (*end != '\0' || field.empty()) {
        ASSERT_EQ(parsed.kind, FieldKind::NotNumber) << field;
    } else if (!std::isfinite(value)) {
        ASSERT_EQ(parsed.kind, FieldKind::NotFinite) << field;
    } else {
        ASSERT_EQ(parsed.kind, FieldKind::Number) << field;
        ASSERT_TRUE(same_bits(parsed.value, value)) << field;
    }
}

TEST(Numbers, AsTheLibraryReadsThem) {
    for (const char* field : {"0",
                              "-0",
                              "+0",
                              "1",
                              "-1",
                              "+1",
                              "1.",
                              ".5",
                              "-.5",
                              "1.e3",
                              "1e3",
                              "1E+3",
                              "1e-3",
                              "1e22",
                              "1e23",
                              "1e-22",
                              "1e-23",
                              "9007199254740993",
                              "999999999999999",
                              "999999999999999e22",
                              "123456789012345.6",
                              "0.000000000000001",
                              "000000000000000001",
                              "5e-324",
                              "1e308",
                              "1e309",
                              "1e-400",
                              "1e99999999999",
                              "1e-99999999999",
                              "0e99999999999",
                              "",
                              "-",
                              "+",
                              ".",
                              "-.",
                              "e",
                              "1e",
                              "1e+",
                              "1e-",
                              "1e.5",
                              "1.2.3",
                              "--1",
                              "1-",
                              "1e5e5",
                              "0.1",
                              "0.3",
                              "4.35"}) {
        expect_as_the_library(field);
    }
}

TEST(Numbers, AnyDigitsPointAndExponent) {
    Random random(77);
    for (int round = 0; round < 200'000; ++round) {
        std::string field = random.next_bits() % 2 == 0 ? "" : "-";
        const std::uint64_t digits = 1 + random.next_bits() % 18;
        const std::uint64_t point = random.next_bits() % 24;
        for (std::uint64_t k = 0; k < digits; ++k) {
            if (k == point) field += '.';
            field += static_cast<char>('0' + random.next_bits() % 10);
        }
        if (random.next_bits() % 2 == 0) {
            const int exponent = static_cast<int>(random.next_bits() % 61) - 30;
            field += (random.next_bits() % 2 == 0 ? "e" : "E") + std::to_string(exponent);
        }
        expect_as_the_library(field);
    }
}

TEST(Numbers, AnyMixture) {
    constexpr std::string_view kCharacters = "0123456789+-.eE";
    Random random(78);
    for (int round = 0; round < 200'000; ++round) {
        std::string field;
        const std::uint64_t length = 1 + random.next_bits() % 6;
        for (std::uint64_t k = 0; k < length; ++k) field += kCharacters[random.next_bits() % kCharacters.size()];
        expect_as_the_library(field);
    }
}

}  // namespace
}  // namespace plateau
