// Holds back the signals that come with a failed write.
#include "files/descriptor.hpp"

#include <cerrno>
#include <csignal>
#include <ctime>
#include <unistd.h>

namespace carom::files
{

namespace
{

/// Blocks SIGPIPE and SIGXFSZ in this thread. One that a write raised meanwhile is taken away, one that was pending before stays.
class HeldBackSignals
{
public:
    HeldBackSignals()
    {
        sigset_t pending;
        ::sigpending(&pending);
        ::sigemptyset(&raised_here_);
        for (const int signal : {SIGPIPE, SIGXFSZ})
            if (::sigismember(&pending, signal) == 0) ::sigaddset(&raised_here_, signal);
        ::pthread_sigmask(SIG_BLOCK, &raised_here_, &before_);
    }
    ~HeldBackSignals()
    {
        const timespec at_once{};
        while (::sigtimedwait(&raised_here_, nullptr, &at_once) > 0)
        {
        }
        ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    }
    HeldBackSignals(const HeldBackSignals&) = delete;
    HeldBackSignals& operator=(const HeldBackSignals&) = delete;

private:
    sigset_t raised_here_;
    sigset_t before_;
};

} // namespace

int Descriptor::close()
{
    const int number = std::exchange(number_, -1);
    // After EINTR the descriptor is closed all the same on Linux; to close it again could hit another thread's file.
    return number < 0 || ::close(number) == 0 || errno == EINTR ? 0 : errno;
}

int write_all(int file, std::span<const std::byte> bytes)
{
    const HeldBackSignals signals;
    while (!bytes.empty())
    {
        const ssize_t count = ::write(file, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return errno;
        bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
    return 0;
}

} // namespace carom::files
