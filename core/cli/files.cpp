#include "cli/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

namespace plateau::cli {
namespace {

/// The one thing that a signal handler may touch.
volatile std::sig_atomic_t interrupt_seen = 0;

void on_interrupt(int) {
    interrupt_seen = 1;
}

Error cannot(ErrorCode code, const char* what, const std::string& path, int reason) {
    return {code, "Cannot " + std::string(what) + " " + path + ": " + std::strerror(reason) + "."};
}

Error cannot_write(const std::string& path) {
    return cannot(ErrorCode::CannotWriteFile, "write", path == "-" ? "standard output" : path, errno);
}

}  // namespace

void catch_signals() {
    struct sigaction action = {};
    action.sa_handler = on_interrupt;
    // Without SA_RESTART: a read that waits for input must return.
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &action, nullptr);
    std::signal(SIGPIPE, SIG_IGN);
}

bool interrupted() {
    return interrupt_seen != 0;
}

Result<std::string> read_file(const std::string& path) {
    const int file = path == "-" ? STDIN_FILENO : open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) return cannot(ErrorCode::CannotReadFile, "read", path, errno);
    std::string bytes;
    // Growing step by step would hold a large file twice.
    struct stat status = {};
    if (fstat(file, &status) == 0 && S_ISREG(status.st_mode) && status.st_size > 0) {
        bytes.reserve(static_cast<std::size_t>(status.st_size));
    }
    std::array<char, 65536> block{};
    int reason = 0;
    while (!interrupted()) {
        const ssize_t got = read(file, block.data(), block.size());
        if (got == 0) break;
        if (got > 0) {
            bytes.append(block.data(), static_cast<std::size_t>(got));
        } else if (errno != EINTR) {
            reason = errno;
            break;
        }
    }
    if (path != "-") close(file);
    if (reason != 0) return cannot(ErrorCode::CannotReadFile, "read", path == "-" ? "standard input" : path, reason);
    return bytes;
}

std::optional<Error> check_writable(const std::string& path) {
    if (path == "-" || path.empty()) return std::nullopt;
    struct stat status = {};
    if (stat(path.c_str(), &status) == 0) {
        errno = EISDIR;
        if (S_ISDIR(status.st_mode) || access(path.c_str(), W_OK) != 0) return cannot_write(path);
        return std::nullopt;
    }
    const std::size_t slash = path.rfind('/');
    const std::string folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
    if (access(folder.c_str(), W_OK) != 0) return cannot_write(path);
    return std::nullopt;
}

std::optional<Error> write_file(const std::string& path, std::string_view text) {
    constexpr mode_t kMode = 0666;
    const bool to_output = path == "-";
    const int file = to_output ? STDOUT_FILENO : open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, kMode);
    if (file < 0) return cannot_write(path);
    while (!text.empty()) {
        const ssize_t written = write(file, text.data(), text.size());
        if (written >= 0) {
            text.remove_prefix(static_cast<std::size_t>(written));
        } else if (errno != EINTR) {
            break;
        }
    }
    std::optional<Error> error;
    if (!text.empty() && !(to_output && errno == EPIPE)) error = cannot_write(path);
    if (!to_output && close(file) != 0 && !error) error = cannot_write(path);
    return error;
}

}  // namespace plateau::cli
