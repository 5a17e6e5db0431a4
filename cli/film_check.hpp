// Whether an animation that another program wrote is complete.
#pragma once

#include <filesystem>
#include <string>

namespace carom::cli
{

enum class AnimationFormat
{
    Mp4,
    Webm,
    Gif
};

/// ffmpeg ends with status 0 at times although the disk was full. So the file must end where its container says that it does, and ffmpeg
/// must find every picture in it again.
/// @param pictures that were given to the encoder
/// @return what is wrong; empty when nothing is
std::string film_problem(const std::filesystem::path& file, AnimationFormat format, int pictures);

} // namespace carom::cli
