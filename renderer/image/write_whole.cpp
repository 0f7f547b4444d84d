// SPDX-License-Identifier: Apache-2.0
// Atomic files. Also compiled into the codec's module, which writes its files the same way.
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <system_error>

#include "error.h"
#include "image/image.h"

namespace umbrage {
namespace {

Error unwritable(const std::filesystem::path& file, const std::string& action, int reason) {
    return {ErrorKind::Output, file.string(),
            fmt::format("cannot {}: {}", action, std::generic_category().message(reason)),
            "make room or choose another place with --out"};
}

void makeFolderOf(const std::filesystem::path& file) {
    std::error_code failed;
    if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), failed);
    if (failed) throw unwritable(file, "make the folder", failed.value());
}

/// In the same folder, and of this thread alone: several threads of several processes may write there.
std::filesystem::path temporaryName(const std::filesystem::path& target) {
    static std::atomic<unsigned> count{0};
    return target.parent_path() /
           fmt::format(".{}.{}-{}.tmp", target.filename().string(), ::getpid(), count.fetch_add(1));
}

/// A file that disappears again unless it is renamed to its final name.
class TemporaryFile {
public:
    explicit TemporaryFile(const std::filesystem::path& target) : target_(target), path_(temporaryName(target)) {
        descriptor_ = ::open(path_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
        if (descriptor_ < 0) throw unwritable(target_, "write into this folder", errno);
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() {
        if (descriptor_ >= 0) ::close(descriptor_);
        if (!kept_) ::unlink(path_.c_str());
    }

    void write(std::string_view bytes) {
        while (!bytes.empty()) {
            const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
            if (written < 0 && errno == EINTR) continue;
            if (written < 0) throw unwritable(target_, "write", errno);
            bytes.remove_prefix(static_cast<std::size_t>(written));
        }
    }

    /// Closes and renames. Network file systems report a full disk only here.
    void keep() {
        const int closed = ::close(std::exchange(descriptor_, -1));
        if (closed != 0) throw unwritable(target_, "write", errno);
        if (::rename(path_.c_str(), target_.c_str()) != 0) throw unwritable(target_, "put the file in place", errno);
        kept_ = true;
    }

private:
    std::filesystem::path target_, path_;
    int descriptor_ = -1;
    bool kept_ = false;
};

}  // namespace

void writeWhole(const std::filesystem::path& file, std::string_view bytes) {
    makeFolderOf(file);
    TemporaryFile temporary(file);
    temporary.write(bytes);
    temporary.keep();
}

void repeatWhole(const std::filesystem::path& file, const std::filesystem::path& other) {
    makeFolderOf(file);
    const std::filesystem::path temporary = temporaryName(file);
    std::error_code failed;
    std::filesystem::create_hard_link(other, temporary, failed);
    if (failed) std::filesystem::copy_file(other, temporary, failed);  // says why, if there is a reason
    if (!failed) std::filesystem::rename(temporary, file, failed);
    // Also where all went well: two names of one file are left alone by rename().
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    if (failed) throw unwritable(file, "make it the same as " + other.string(), failed.value());
}

}  // namespace umbrage
