// The files that a command writes, and where its words go beside them.
#pragma once

#include "cli/program.hpp"
#include "files/output_file.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace carom::cli
{

class Outputs
{
public:
    explicit Outputs(const Surroundings& surroundings) : surroundings_(surroundings) {}

    /// Opens a file, so that a place that can't be written is found before the work is done.
    /// @param option the command-line option that names the file; "-" is standard output
    /// @throws files::BadTarget
    /// @throws BadUsage when another option writes the same file
    files::OutputFile& open(const std::string& option, const std::string& path);
    /// Null for an option that was not given.
    files::OutputFile* open(const std::string& option, const std::optional<std::string>& path);

    /// For what people read: standard output, or standard error when a file is written to standard output, whose bytes stay clean.
    std::ostream& words() const;

private:
    const Surroundings& surroundings_;
    std::vector<std::unique_ptr<files::OutputFile>> files_;
};

} // namespace carom::cli
