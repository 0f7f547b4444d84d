// SPDX-License-Identifier: Apache-2.0
// What was odd but harmless while loading a glTF file. The same oddity in many places becomes one line.
#pragma once

#include <fmt/format.h>

#include <map>
#include <string>
#include <vector>

namespace umbrage {

class GltfNotes {
public:
    void add(const std::string& pointer, const std::string& message) {
        const auto [entry, isNew] = indices_.try_emplace(message, notes_.size());
        if (isNew) {
            notes_.push_back({pointer, message, 1});
        } else {
            ++notes_[entry->second].count;
        }
    }

    /// "file: /pointer: message (and 3 more)", in the order of their first appearance.
    std::vector<std::string> lines(const std::string& file) const {
        std::vector<std::string> result;
        for (const Note& note : notes_) {
            result.push_back(fmt::format("{}: {}{}{}{}", file, note.firstPointer, note.firstPointer.empty() ? "" : ": ",
                                         note.message,
                                         note.count > 1 ? fmt::format(" (and {} more)", note.count - 1) : ""));
        }
        return result;
    }

private:
    struct Note {
        std::string firstPointer, message;
        std::size_t count;
    };
    std::vector<Note> notes_;
    std::map<std::string, std::size_t> indices_;
};

}  // namespace umbrage
