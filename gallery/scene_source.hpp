// What the gallery can open: named scenes, benchmarks of the laboratory, and scene files.
#pragma once

#include "scenes/scene.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

namespace carom::gallery
{

/// Makes one scene, as often as it is restarted. Copies are cheap.
class SceneSource
{
public:
    using Maker = std::function<std::unique_ptr<scenes::Scene>(const scenes::ParameterValues&, std::uint64_t seed)>;

    SceneSource(std::shared_ptr<const scenes::SceneInfo> info, Maker make, std::filesystem::path file = {})
        : info_(std::move(info)),
          make_(std::move(make)),
          file_(std::move(file))
    {
    }
    /// The file as it is now: a later change of it does not show.
    /// @throws lab::SceneFileError when it can't be read or holds no scene, with the place
    static SceneSource of_file(const std::filesystem::path& file);

    const scenes::SceneInfo& info() const { return *info_; }    ///< name, title and group as the list shows them
    const std::filesystem::path& file() const { return file_; } ///< empty for a scene that is built in
    /// @throws SceneError
    std::unique_ptr<scenes::Scene> make(const scenes::ParameterValues& values, std::uint64_t seed) const { return make_(values, seed); }

private:
    std::shared_ptr<const scenes::SceneInfo> info_;
    Maker make_;
    std::filesystem::path file_;
};

/// All that is built in, in the order of the list: the named scenes, then the benchmarks.
const std::vector<SceneSource>& catalogue();
/// @throws SceneError naming a scene of a similar name, or all of them
const SceneSource& find_source(std::string_view name);

} // namespace carom::gallery
