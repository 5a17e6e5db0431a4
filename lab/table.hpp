// Tables of text.
#pragma once

#include <string>
#include <vector>

namespace carom::lab
{

/// Rows of cells; the first row is the head. Rows may be of different lengths.
class Table
{
public:
    explicit Table(std::vector<std::string> head) { rows_.push_back(std::move(head)); }

    void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }

    bool is_empty() const { return rows_.size() < 2; } ///< nothing but the head

    std::string text() const; ///< columns as wide as they must be, numbers to the right
    std::string markdown() const;
    std::string html() const;

private:
    std::size_t columns() const;
    const std::string& cell(std::size_t row, std::size_t column) const;

    std::vector<std::vector<std::string>> rows_;
};

/// A number with so many digits that matter: "0.0123", "4.57", "1230".
std::string number_text(double value, int digits = 3);
/// With &, < and > written so that a page shows them.
std::string html_text(const std::string& text);

} // namespace carom::lab
