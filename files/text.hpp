// Text from outside - names in files, paths, what other programs said - made safe to print.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace carom::files
{

/// The text as valid UTF-8 that a terminal shows and does not obey. Escaped are control characters (C0 as \x1b, DEL, C1 as \u009b), the
/// characters that reorder a line (bidirectional controls, U+2028, U+2029), and bytes that are not UTF-8 (\xff). Line feeds and tabs stay.
std::string printable(std::string_view text);

/// The same on one line: line feeds and tabs are escaped too, as \n and \t.
std::string printable_line(std::string_view text);

/// A name or a path in double quotes for a message: as printable(), and line feeds, tabs, quotes and backslashes are escaped too, so that a name
/// can't pass for another line or end its quotes.
std::string quoted(const std::filesystem::path& name);

} // namespace carom::files
