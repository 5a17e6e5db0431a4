// Starts ffmpeg, writes pictures into its standard input, and keeps what it says for error messages.
#include "cli/encoder.hpp"

#include "cli/errors.hpp"
#include "files/output_file.hpp"
#include "files/text.hpp"
#include "scenes/text.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace carom::cli
{

namespace
{

std::vector<std::string> format_options(AnimationFormat format)
{
    switch (format)
    {
    case AnimationFormat::Mp4:
        return {"-c:v", "libx264", "-preset", "medium", "-crf", "23", "-pix_fmt", "yuv420p", "-movflags", "+faststart", "-f", "mp4"};
    case AnimationFormat::Webm:
        return {"-c:v", "libvpx-vp9", "-b:v", "0",        "-crf",    "30", "-deadline",
                "good", "-cpu-used",  "5",    "-pix_fmt", "yuv420p", "-f", "webm"};
    case AnimationFormat::Gif: break;
    }
    // A palette for each picture: one for all would hold every picture in memory until the end.
    return {"-vf", "split[a][b];[a]palettegen=stats_mode=single[p];[b][p]paletteuse=new=1:dither=none", "-f", "gif"};
}

} // namespace

AnimationFormat animation_format_of(const std::filesystem::path& path)
{
    const std::string extension = scenes::lower_case(path.extension().string());
    if (extension == ".mp4") return AnimationFormat::Mp4;
    if (extension == ".webm") return AnimationFormat::Webm;
    if (extension == ".gif") return AnimationFormat::Gif;
    if (files::is_written_through(path)) return AnimationFormat::Webm; // the one of them that is made for streams
    throw BadUsage("--animation: " + files::quoted(path) + " has an unknown format; give a name that ends in .mp4, .webm or .gif");
}

scenes::Viewport animation_size(AnimationFormat format)
{
    return format == AnimationFormat::Gif ? scenes::Viewport{640, 360} : scenes::Viewport{960, 540};
}

Encoder::Encoder(const std::filesystem::path& file, AnimationFormat format, scenes::Viewport size, double frames)
    : file_(file),
      format_(format),
      messages_(std::tmpfile())
{
    if (!messages_) throw Failure(std::string("can't make a temporary file: ") + std::strerror(errno));
    const std::string picture_size = std::to_string(size.width) + "x" + std::to_string(size.height);
    std::vector<std::string> command = {
        "ffmpeg", "-hide_banner",         "-xerror", "-loglevel", "error", "-y", "-f", "rawvideo", "-pix_fmt", "bgr0", "-s", picture_size,
        "-r",     std::to_string(frames), "-i",      "-"};
    for (std::string& option : format_options(format)) command.push_back(std::move(option));
    command.push_back("file:" + file.string()); // whatever the name looks like, it is a file
    start(command);
}

Encoder::~Encoder()
{
    pipe_.close();
    if (process_ < 0) return;
    ::kill(process_, SIGTERM);
    wait();
}

void Encoder::start(const std::vector<std::string>& command)
{
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str())); // execvp's old signature; it only reads
    arguments.push_back(nullptr);

    std::array<int, 2> ends;
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw Failure(std::string("can't make a pipe: ") + std::strerror(errno));
    const files::Descriptor read_end(ends[0]);
    pipe_ = files::Descriptor(ends[1]);

    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, read_end.number(), STDIN_FILENO);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&files, ::fileno(messages_.get()), STDERR_FILENO);
    const int error = ::posix_spawnp(&process_, arguments[0], &files, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    if (error == 0) return;

    process_ = -1;
    pipe_.close();
    if (error == ENOENT)
        throw Failure("ffmpeg was not found on the PATH; install it (the package is called ffmpeg), or leave out --animation");
    throw Failure(std::string("can't start ffmpeg: ") + std::strerror(error));
}

void Encoder::add_frame(std::span<const std::byte> pixels)
{
    ++frames_;
    if (const int error = files::write_all(pipe_.number(), pixels)) fail(std::strerror(error)); // ffmpeg has ended, and says why
}

void Encoder::finish()
{
    pipe_.close();
    const int status = wait();
    if (WIFSIGNALED(status)) fail(::strsignal(WTERMSIG(status)));
    if (status != 0) fail("status " + std::to_string(WEXITSTATUS(status)));
    if (const std::string problem = film_problem(file_, format_, frames_); !problem.empty()) fail(problem);
}

/// @return how the process ended; zero is well
int Encoder::wait()
{
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR)
    {
    }
    process_ = -1;
    return status;
}

/// @param why when ffmpeg itself says nothing
void Encoder::fail(const std::string& why)
{
    pipe_.close();
    if (process_ >= 0) wait();
    std::string said;
    std::array<char, 512> part;
    std::rewind(messages_.get());
    while (const std::size_t count = std::fread(part.data(), 1, part.size(), messages_.get())) said.append(part.data(), count);
    while (!said.empty() && said.back() == '\n') said.pop_back();
    throw Failure("--animation: ffmpeg failed: " + (said.empty() ? why : said));
}

} // namespace carom::cli
