// SPDX-License-Identifier: Apache-2.0
// Made from the library's events rather than from its nodes: limits then hold while the text is read, aliases keep
// their own places, and its loop over documents is not used, which never ends on text such as ",a" (yaml-cpp 0.7).
#include "job/yaml_tree.h"

#include <fmt/core.h>
#include <yaml-cpp/anchor.h>
#include <yaml-cpp/depthguard.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <unordered_map>

#include "error.h"
#include "job/utf8.h"

namespace umbrage {
namespace {

constexpr std::size_t kMostBytes = 4u << 20;
constexpr std::size_t kMostNodes = 250'000;  // an alias counts as all it stands for
constexpr std::size_t kDeepest = 64;

class TreeBuilder final : public YAML::EventHandler {
public:
    /// @param fixedPlace  of all nodes, for text that is in no file
    TreeBuilder(std::string name, const Place* fixedPlace) : name_(std::move(name)), fixedPlace_(fixedPlace) {}

    // The library counts from 0, and -1 means that it does not know.
    Place placeOf(const YAML::Mark& mark) const {
        if (fixedPlace_) return *fixedPlace_;
        return {name_, std::max(mark.line, 0) + 1, std::max(mark.column, 0) + 1};
    }

    YamlNode takeRoot() { return std::move(root_); }

    void OnDocumentStart(const YAML::Mark& mark) override {
        if (++documentCount_ > 1)
            refuse({.place = placeOf(mark)}, "the document has ended, but the text goes on",
                   "remove a second '---', or a stray bracket or comma");
    }
    void OnDocumentEnd() override {}

    void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override { finish({.place = placeOf(mark)}, anchor); }

    void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  const std::string& value) override {
        YamlNode node = begun(YamlNode::Kind::Scalar, mark, tag);
        node.plain = tag == "?";
        node.scalar = value;
        finish(std::move(node), anchor);
    }

    void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                         YAML::EmitterStyle::value) override {
        open(YamlNode::Kind::Sequence, mark, tag, anchor);
    }
    void OnSequenceEnd() override { close(); }

    void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                    YAML::EmitterStyle::value) override {
        open(YamlNode::Kind::Mapping, mark, tag, anchor);
    }
    void OnMapEnd() override { close(); }

    void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
        const YamlNode here{.place = placeOf(mark)};
        const auto known = anchors_.find(anchor);
        if (known == anchors_.end()) refuse(here, "an alias contains itself");
        nodeCount_ += known->second.nodeCount;
        limitNodes(here);
        YamlNode node = known->second.node;
        node.place = here.place;
        add(std::move(node));
    }

private:
    struct Open {
        YamlNode node;
        YAML::anchor_t anchor;
        std::size_t nodeCountBefore;
        std::unordered_map<std::string, Place> keys{};
    };
    struct Anchored {
        YamlNode node;
        std::size_t nodeCount;
    };

    void limitNodes(const YamlNode& here) const {
        if (nodeCount_ > kMostNodes)
            refuse(here, fmt::format("there are more than {} values", kMostNodes),
                   "an alias counts as all the values it stands for");
    }

    YamlNode begun(YamlNode::Kind kind, const YAML::Mark& mark, const std::string& tag) const {
        YamlNode node{.kind = kind, .place = placeOf(mark)};
        if (!tag.empty() && tag != "?" && tag != "!")
            refuse(node, fmt::format("the tag {} is not supported", tag), "leave it out; quote what is to be a string");
        if (open_.size() >= kDeepest) refuse(node, "values are nested too deeply");
        return node;
    }

    void open(YamlNode::Kind kind, const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) {
        open_.push_back({begun(kind, mark, tag), anchor, nodeCount_});
    }

    void close() {
        Open closed = std::move(open_.back());
        open_.pop_back();
        finish(std::move(closed.node), closed.anchor, closed.nodeCountBefore);
    }

    void finish(YamlNode node, YAML::anchor_t anchor) { finish(std::move(node), anchor, nodeCount_); }

    void finish(YamlNode node, YAML::anchor_t anchor, std::size_t nodeCountBefore) {
        ++nodeCount_;
        limitNodes(node);
        if (anchor != YAML::NullAnchor) anchors_[anchor] = {node, nodeCount_ - nodeCountBefore};
        add(std::move(node));
    }

    void add(YamlNode node) {
        if (open_.empty()) {
            root_ = std::move(node);
            return;
        }
        Open& parent = open_.back();
        if (parent.node.isSequence())
            parent.node.items.push_back(std::move(node));
        else if (parent.node.keys.size() == parent.node.items.size())
            addKey(parent, std::move(node));
        else
            addValue(parent.node, std::move(node));
    }

    static void addKey(Open& parent, YamlNode key) {
        if (!key.isScalar()) refuse(key, fmt::format("a key cannot be {}", describe(key)), "quote it");
        if (key.plain && key.scalar == "<<")
            refuse(key, "merge keys (<<) are not supported", "write the keys out, or use an alias as a whole value");
        const auto [earlier, isNew] = parent.keys.emplace(key.scalar, key.place);
        if (!isNew)
            refuse(key, fmt::format("the key \"{}\" is there twice", key.scalar),
                   fmt::format("the first is at {}", earlier->second.text()));
        parent.node.keys.push_back(std::move(key));
    }

    static void addValue(YamlNode& mapping, YamlNode value) {
        // Of a value that is not there the library knows only what comes next, which may be far below.
        const Place& key = mapping.keys.back().place;
        if (value.kind == YamlNode::Kind::Null && value.place.line != key.line) value.place = key;
        mapping.items.push_back(std::move(value));
    }

    std::string name_;
    const Place* fixedPlace_;
    YamlNode root_;
    std::vector<Open> open_;
    std::unordered_map<YAML::anchor_t, Anchored> anchors_;
    std::size_t nodeCount_ = 0;
    int documentCount_ = 0;
};

bool indentedWithTab(std::string_view text, int line) {
    for (; line > 0 && !text.empty(); --line) text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
    return text.substr(0, text.find_first_not_of(" \t")).find('\t') != std::string_view::npos;
}

YamlNode parse(const std::string& text, const std::string& name, const Place* fixedPlace) {
    TreeBuilder builder(name, fixedPlace);
    const auto fail = [&](const YAML::Mark& mark, const std::string& message, const std::string& hint = {}) {
        refuse({.place = builder.placeOf(mark)}, message, hint);
    };
    if (text.size() > kMostBytes)
        fail({}, fmt::format("the text has {} bytes; at most {} are read", text.size(), kMostBytes));
    if (const auto bad = firstUnreadableByte(text)) {
        YAML::Mark mark;
        mark.line = bad->line - 1;
        mark.column = bad->column - 1;
        fail(mark, "this is not text in UTF-8", "save the file as UTF-8");
    }
    try {
        std::istringstream stream(text);
        YAML::Parser parser(stream);
        if (parser.HandleNextDocument(builder)) parser.HandleNextDocument(builder);  // of which there must be none
    } catch (const YAML::DeepRecursion& error) {
        fail(error.mark, "values are nested too deeply");
    } catch (const YAML::Exception& error) {
        fail(error.mark, error.msg,
             indentedWithTab(text, error.mark.line) ? "indent with spaces: YAML takes no tabs"
                                                    : "this is not valid YAML");
    }
    YamlNode root = builder.takeRoot();
    if (root.place.file.empty()) root.place = builder.placeOf({});
    return root;
}

}  // namespace

std::string Place::text() const {
    return line == 0 ? file : fmt::format("{}:{}:{}", file, line, column);
}

const YamlNode* YamlNode::find(std::string_view key) const {
    for (std::size_t i = 0; i < keys.size(); ++i)
        if (keys[i].scalar == key) return &items[i];
    return nullptr;
}

YamlNode* YamlNode::find(std::string_view key) {
    return const_cast<YamlNode*>(std::as_const(*this).find(key));
}

std::string contentsOf(const std::filesystem::path& file) {
    std::error_code ignored;
    const bool isFolder = std::filesystem::is_directory(file, ignored);
    std::ifstream stream(file, std::ios::binary);
    if (!stream || isFolder)
        throw Error(ErrorKind::Input, file.string(),
                    isFolder ? "this is a folder" : std::string("cannot be read: ") + std::strerror(errno));
    return {std::istreambuf_iterator<char>(stream), {}};
}

YamlNode parseYaml(const std::string& text, const std::string& name) {
    return parse(text, name, nullptr);
}

YamlNode parseYamlValue(const std::string& text, const Place& place) {
    return parse(text, place.file, &place);
}

}  // namespace umbrage
