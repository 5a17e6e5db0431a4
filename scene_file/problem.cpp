// A problem as one line of text.
#include "files/text.hpp"

#include <carom/scene_file.hpp>

namespace carom
{

namespace
{

std::string on_one_line(const std::string& text)
{
    std::string line;
    for (const char c : files::printable(text))
    {
        if (c == '\n')
            line += "\\n";
        else if (c == '\t')
            line += "\\t";
        else
            line += c;
    }
    return line;
}

} // namespace

std::string SceneProblem::text() const
{
    std::string text = source;
    if (line > 0) text += ":" + std::to_string(line) + ":" + std::to_string(column);
    if (!text.empty()) text += ": ";
    if (!field.empty()) text += field + " ";
    return on_one_line(text + message);
}

} // namespace carom
