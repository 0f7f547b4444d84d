// SPDX-License-Identifier: Apache-2.0
#include "process.h"

#include <fcntl.h>
#include <pty.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <thread>

extern char** environ;

namespace umbrage::cli {
namespace {

/// The reading end of a child's output, which never blocks.
class Stream {
public:
    explicit Stream(bool terminal) {
        std::array<int, 2> ends{};
        const int failed = terminal ? ::openpty(&ends[0], &ends[1], nullptr, nullptr, nullptr) : ::pipe(ends.data());
        if (failed != 0) throw std::runtime_error(std::string("no pipe: ") + std::strerror(errno));
        read_ = ends[0];
        write_ = ends[1];
        for (const int end : ends) ::fcntl(end, F_SETFD, FD_CLOEXEC);
        ::fcntl(read_, F_SETFL, O_NONBLOCK);
    }
    ~Stream() {
        ::close(read_);
        closeWriting();
    }
    Stream(const Stream&) = delete;
    Stream& operator=(const Stream&) = delete;

    int writing() const { return write_; }
    void closeWriting() {
        if (write_ >= 0) ::close(write_);
        write_ = -1;
    }
    void readInto(std::string& text) const {
        std::array<char, 4096> some{};
        for (ssize_t n = 0; (n = ::read(read_, some.data(), some.size())) > 0;)
            text.append(some.data(), std::size_t(n));
    }

private:
    int read_ = -1, write_ = -1;
};

std::vector<char*> pointersTo(std::vector<std::string>& strings) {
    std::vector<char*> pointers;
    for (std::string& text : strings) pointers.push_back(text.data());
    pointers.push_back(nullptr);
    return pointers;
}

pid_t start(const Launch& launch, const std::vector<std::string>& arguments, const Stream& out, const Stream& err) {
    std::vector<std::string> words{launch.program.empty() ? UMBRAGE_PROGRAM : launch.program.string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<std::string> environment = launch.environment;
    for (char** variable = environ; *variable; ++variable) environment.emplace_back(*variable);
    environment.emplace_back(
        "ASAN_OPTIONS=detect_leaks=0");  // OpenGL drivers and the image libraries leak at their end

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    if (!launch.folder.empty()) posix_spawn_file_actions_addchdir_np(&actions, launch.folder.c_str());
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    if (launch.standardOutput.empty()) {
        posix_spawn_file_actions_adddup2(&actions, out.writing(), STDOUT_FILENO);
    } else {
        posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, launch.standardOutput.c_str(), O_WRONLY, 0);
    }
    posix_spawn_file_actions_adddup2(&actions, err.writing(), STDERR_FILENO);
    pid_t child = 0;
    const int failed = ::posix_spawn(&child, words[0].c_str(), &actions, nullptr, pointersTo(words).data(),
                                     pointersTo(environment).data());
    posix_spawn_file_actions_destroy(&actions);
    if (failed != 0) throw std::runtime_error(words[0] + ": " + std::strerror(failed));
    return child;
}

}  // namespace

Result run(const Launch& launch, const std::vector<std::string>& arguments) {
    using Clock = std::chrono::steady_clock;
    Stream out(false), err(launch.terminal);
    const Clock::time_point begin = Clock::now();
    const pid_t child = start(launch, arguments, out, err);
    out.closeWriting();
    err.closeWriting();

    Result result;
    bool signalled = false;
    int status = 0;
    rusage usage{};
    const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
    for (bool ended = false; !ended;) {
        ended = ::wait4(child, &status, WNOHANG, &usage) == child;
        out.readInto(result.out);
        err.readInto(result.err);
        if (ended) break;
        const int signal = launch.signal && !signalled ? launch.signal(result.err) : 0;
        if (signal != 0) {
            ::kill(child, signal);
            signalled = true;
        }
        if (elapsed() > launch.limitSeconds && !result.killed) {
            ::kill(child, SIGKILL);
            result.killed = true;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    result.seconds = elapsed();
    result.exitCode = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
    result.peakMebibytes = double(usage.ru_maxrss) / 1024.0;
    return result;
}

}  // namespace umbrage::cli
