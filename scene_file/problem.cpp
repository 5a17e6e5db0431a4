// A problem as one line of text.
#include "files/text.hpp"

#include <carom/scene_file.hpp>

namespace carom
{

std::string SceneProblem::text() const
{
    std::string text = source;
    if (line > 0) text += ":" + std::to_string(line) + ":" + std::to_string(column);
    if (!text.empty()) text += ": ";
    if (!field.empty()) text += field + " ";
    return files::printable_line(text + message);
}

} // namespace carom
