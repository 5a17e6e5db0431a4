// Text from outside reaches a terminal as text alone.
#include "files/text.hpp"

#include <gtest/gtest.h>

namespace carom::files
{

TEST(Printable, keeps_text_of_every_language_and_its_lines)
{
    const std::string text = "Kiste \xC3\xA4, \xE7\xAE\xB1, \xF0\x9F\x8E\xB1\n\tnext \"line\" \\ end";
    EXPECT_EQ(printable(text), text);
    EXPECT_EQ(printable(""), "");
}

TEST(Printable, escapes_what_a_terminal_obeys)
{
    EXPECT_EQ(printable("\x1b[31mred\x1b]0;title\a"), "\\x1b[31mred\\x1b]0;title\\x07");
    EXPECT_EQ(printable(std::string_view("a\0b\r\b\x7f", 6)), "a\\x00b\\x0d\\x08\\x7f");
    EXPECT_EQ(printable("\xC2\x9B"
                        "31m"),
              "\\u009b31m")
        << "CSI as one character";
    EXPECT_EQ(printable("\xE2\x80\xAE"
                        "gpj.exe"),
              "\\u202egpj.exe")
        << "right to left";
}

TEST(Printable, marks_bytes_that_are_no_utf_8)
{
    EXPECT_EQ(printable("a\xFF\xFE"
                        "b"),
              "a\\xff\\xfeb");
    EXPECT_EQ(printable("\xC0\xAF"), "\\xc0\\xaf") << "an overlong slash";
    EXPECT_EQ(printable("\xED\xA0\x80"), "\\xed\\xa0\\x80") << "half of a surrogate pair";
    EXPECT_EQ(printable("\xF4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80") << "beyond U+10FFFF";
    EXPECT_EQ(printable("\xE7\xAE"), "\\xe7\\xae") << "cut within a character";
    EXPECT_EQ(printable("\x80"), "\\x80");
}

TEST(PrintableLine, escapes_what_would_begin_another_line)
{
    EXPECT_EQ(printable_line("a\nb\tc \x1b\xff \\n"), "a\\nb\\tc \\x1b\\xff \\n");
    EXPECT_EQ(printable_line("\xc3\xa4"), "\xc3\xa4");
}

TEST(Quoted, a_name_is_one_line_and_can_not_end_its_quotes)
{
    EXPECT_EQ(quoted("a b.png"), "\"a b.png\"");
    EXPECT_EQ(quoted("a\n\"b\"\\\t\x1b"), "\"a\\n\\\"b\\\"\\\\\\t\\x1b\"");
    EXPECT_EQ(quoted(std::filesystem::path("\xFF.png")), "\"\\xff.png\"");
}

} // namespace carom::files
