// Starts a program with a pipe for what it says, and waits for it.
#include "lab/process.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace carom::lab
{

namespace
{

using Clock = std::chrono::steady_clock;

constexpr std::size_t most_kept = 4000; // characters of what it says

class Pipe
{
public:
    Pipe() { is_open_ = ::pipe2(ends_.data(), O_CLOEXEC) == 0; }
    ~Pipe()
    {
        close_writer();
        if (is_open_) ::close(ends_[0]);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;

    bool is_open() const { return is_open_; }
    int reader() const { return ends_[0]; }
    int writer() const { return ends_[1]; }
    void close_writer()
    {
        if (is_open_ && ends_[1] >= 0) ::close(ends_[1]);
        ends_[1] = -1;
    }

private:
    std::array<int, 2> ends_ = {-1, -1};
    bool is_open_ = false;
};

/// @param output of the program; -1 for nowhere
/// @return the new process, or -1
pid_t start(const std::vector<std::string>& command, int errors, int output)
{
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    if (output >= 0)
        posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
    else
        posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, errors, STDERR_FILENO);
    pid_t process = -1;
    const int error = posix_spawnp(&process, arguments.front(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    return error == 0 ? process : -1;
}

/// How long a program may go on.
struct Patience
{
    Clock::time_point end;
    const std::function<bool()>& is_interrupted;

    bool is_over() const { return Clock::now() >= end || (is_interrupted && is_interrupted()); }
};

/// Something that a program writes, and who gets it.
struct Source
{
    int reader = -1; ///< -1 once the program has closed its side
    std::function<void(std::string_view)> take;
};

/// Hands on what there is to read.
void read_from(Source& source)
{
    std::array<char, 4096> buffer;
    const ssize_t count = ::read(source.reader, buffer.data(), buffer.size());
    if (count > 0)
        source.take(std::string_view(buffer.data(), static_cast<std::size_t>(count)));
    else if (count == 0 || errno != EINTR)
        source.reader = -1;
}

/// Reads until the program has closed all sides or the patience is over.
/// @return false when it was over
bool listen(std::array<Source, 2> sources, const Patience& patience)
{
    while (std::any_of(sources.begin(), sources.end(), [](const Source& source) { return source.reader >= 0; }))
    {
        if (patience.is_over()) return false;
        constexpr int look_again = 100; // [ms]
        std::array<pollfd, 2> wanted{};
        for (std::size_t i = 0; i < sources.size(); ++i) wanted[i] = {.fd = sources[i].reader, .events = POLLIN, .revents = 0};
        if (::poll(wanted.data(), wanted.size(), look_again) <= 0) continue;
        for (std::size_t i = 0; i < sources.size(); ++i)
            if (wanted[i].revents != 0) read_from(sources[i]);
    }
    return true;
}

/// Waits for a program that no longer says anything, and leaves its status to be asked for.
/// @return false when the patience is over
bool has_ended(pid_t process, const Patience& patience)
{
    while (!patience.is_over())
    {
        siginfo_t info{};
        if (::waitid(P_PID, static_cast<id_t>(process), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == process) return true;
        ::usleep(1000);
    }
    return false;
}

} // namespace

ProcessResult run_process(const std::vector<std::string>& command, double seconds, const std::function<bool()>& is_interrupted,
                          const std::function<void(std::string_view)>& on_output)
{
    ProcessResult result;
    Pipe errors;
    Pipe output;
    if (command.empty() || !errors.is_open() || !output.is_open()) return result;
    const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
    const pid_t process = start(command, errors.writer(), on_output ? output.writer() : -1);
    if (process < 0) return result;
    errors.close_writer();
    output.close_writer();
    result.is_started = true;
    const Patience patience{.end = end, .is_interrupted = is_interrupted};
    const auto keep = [&](std::string_view words)
    {
        result.errors += words;
        if (result.errors.size() > 2 * most_kept) result.errors.erase(0, result.errors.size() - most_kept);
    };
    const Source said{.reader = errors.reader(), .take = keep};
    const Source written{.reader = on_output ? output.reader() : -1, .take = on_output};
    result.is_timeout = !listen({said, written}, patience) || !has_ended(process, patience);
    if (result.is_timeout) ::kill(process, SIGKILL);
    int status = 0;
    while (::waitpid(process, &status, 0) < 0 && errno == EINTR)
    {
    }
    result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    if (result.errors.size() > most_kept) result.errors.erase(0, result.errors.size() - most_kept);
    return result;
}

} // namespace carom::lab
