// Turns pictures into an animation, by handing them to ffmpeg.
#pragma once

#include "cli/film_check.hpp"
#include "files/descriptor.hpp"
#include "scenes/camera.hpp"

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <sys/types.h>
#include <vector>

namespace carom::cli
{

/// By the file's extension. Standard output, a FIFO or a device without one of them gets WebM.
/// @throws BadUsage when it is none of .mp4, .webm and .gif
AnimationFormat animation_format_of(const std::filesystem::path& path);
/// Size of a picture: small for gifs, which grow fast.
scenes::Viewport animation_size(AnimationFormat format);

/// A running ffmpeg that takes pictures one by one.
class Encoder
{
public:
    /// @param file   a regular file, which is overwritten
    /// @param frames a second
    /// @throws Failure when ffmpeg can't be started
    Encoder(const std::filesystem::path& file, AnimationFormat format, scenes::Viewport size, double frames);
    ~Encoder(); ///< stops it when it was not finished
    Encoder(const Encoder&) = delete;
    Encoder& operator=(const Encoder&) = delete;

    /// @param pixels as Canvas::pixels() gives them
    /// @throws Failure with what ffmpeg said
    void add_frame(std::span<const std::byte> pixels);
    /// Waits until the file is complete, and checks that it holds every picture.
    /// @throws Failure with what ffmpeg said
    void finish();

private:
    struct CloseFile
    {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };

    void start(const std::vector<std::string>& command);
    int wait();
    [[noreturn]] void fail(const std::string& why);

    std::filesystem::path file_;
    AnimationFormat format_;
    std::unique_ptr<std::FILE, CloseFile> messages_; ///< what ffmpeg says
    files::Descriptor pipe_;                         ///< to ffmpeg
    pid_t process_ = -1;
    int frames_ = 0; ///< that it was given
};

} // namespace carom::cli
