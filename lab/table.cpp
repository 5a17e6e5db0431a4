// Lays tables out.
#include "lab/table.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>

namespace carom::lab
{

namespace
{

const std::string nothing;

/// Whether a cell reads as a number, with whatever unit stands behind it.
bool is_number(const std::string& cell) { return !cell.empty() && (std::isdigit(static_cast<unsigned char>(cell[0])) || cell[0] == '-'); }

std::string padded(const std::string& cell, std::size_t width)
{
    const std::string space(width - std::min(width, cell.size()), ' ');
    return is_number(cell) ? space + cell : cell + space;
}

} // namespace

std::size_t Table::columns() const
{
    std::size_t most = 0;
    for (const std::vector<std::string>& row : rows_) most = std::max(most, row.size());
    return most;
}

const std::string& Table::cell(std::size_t row, std::size_t column) const
{
    return column < rows_[row].size() ? rows_[row][column] : nothing;
}

std::string Table::text() const
{
    std::string out;
    for (std::size_t row = 0; row < rows_.size(); ++row)
    {
        std::string line;
        for (std::size_t column = 0; column < columns(); ++column)
        {
            std::size_t width = 0;
            for (std::size_t other = 0; other < rows_.size(); ++other) width = std::max(width, cell(other, column).size());
            line += padded(cell(row, column), width) + "  ";
        }
        line.erase(line.find_last_not_of(' ') + 1);
        out += line + "\n";
    }
    return out;
}

std::string Table::markdown() const
{
    std::string out;
    for (std::size_t row = 0; row < rows_.size(); ++row)
    {
        out += "|";
        for (std::size_t column = 0; column < columns(); ++column) out += " " + cell(row, column) + " |";
        out += "\n";
        if (row > 0) continue;
        out += "|";
        for (std::size_t column = 0; column < columns(); ++column) out += "---|";
        out += "\n";
    }
    return out;
}

std::string Table::html() const
{
    std::string out = "<table>\n";
    for (std::size_t row = 0; row < rows_.size(); ++row)
    {
        const std::string kind = row == 0 ? "th" : "td";
        out += "<tr>";
        for (std::size_t column = 0; column < columns(); ++column)
        {
            const std::string& words = cell(row, column);
            out += "<" + kind + (is_number(words) ? " class=\"number\">" : ">") + html_text(words) + "</" + kind + ">";
        }
        out += "</tr>\n";
    }
    return out + "</table>\n";
}

std::string number_text(double value, int digits)
{
    if (!std::isfinite(value)) return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
    const double size = std::abs(value);
    const int whole = size >= 1 ? static_cast<int>(std::floor(std::log10(size))) + 1 : 0;
    const int zeros = size > 0 && size < 1 ? -static_cast<int>(std::floor(std::log10(size))) - 1 : 0;
    constexpr int most_zeros = 4; // behind the point: smaller ones are written with an exponent
    std::array<char, 64> text{};
    if (zeros > most_zeros || whole > 12)
        std::snprintf(text.data(), text.size(), "%.*e", digits - 1, value);
    else
        std::snprintf(text.data(), text.size(), "%.*f", size == 0 ? 0 : std::max(0, digits - whole + zeros), value);
    return text.data();
}

std::string html_text(const std::string& text)
{
    std::string out;
    for (const char c : text)
    {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (c == '>')
            out += "&gt;";
        else
            out += c;
    }
    return out;
}

} // namespace carom::lab
