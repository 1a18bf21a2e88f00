// Lines and their numbers under every convention of ending them.

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "io/text.h"

namespace plateau {
namespace {

using Lines = std::vector<std::pair<std::uint64_t, std::string>>;

Lines numbered(std::string_view text) {
    Lines lines;
    LineScanner scanner(text);
    while (const auto line = scanner.next()) lines.emplace_back(scanner.line_number(), *line);
    return lines;
}

TEST(LineScanner, EndsOfEverySystemCountOnce) {
    const Lines expected{{1, "a"}, {2, ""}, {3, "b"}};
    EXPECT_EQ(numbered("a\n\nb\n"), expected);
    EXPECT_EQ(numbered("a\r\n\r\nb\r\n"), expected);
    EXPECT_EQ(numbered("a\r\rb\r"), expected);
}

TEST(LineScanner, TheLastLineNeedsNoEnd) {
    const Lines expected{{1, "a"}, {2, "b"}};
    EXPECT_EQ(numbered("a\nb"), expected);
    EXPECT_EQ(numbered("a\r\nb"), expected);
    EXPECT_EQ(numbered(""), Lines{});
}

}  // namespace
}  // namespace plateau
