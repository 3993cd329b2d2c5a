#include "core/io/json_keys.h"

#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>

#include <set>
#include <vector>

namespace fff::io {

namespace {

/// Behind the closing quote of the text that begins here.
std::size_t endOfText(std::string_view json, std::size_t begin)
{
    std::size_t at = begin + 1;
    while (at < json.size() && json[at] != '"')
        at += json[at] == '\\' ? 2 : 1;
    return at + 1;
}

bool isKey(std::string_view json, std::size_t end)
{
    const std::size_t next = json.find_first_not_of(" \t\r\n", end);
    return next != std::string_view::npos && json[next] == ':';
}

/// quoted: with its quotes.
std::string meaning(std::string_view quoted)
{
    if (quoted.find('\\') == std::string_view::npos)
        return std::string(quoted.substr(1, quoted.size() - 2));
    const QByteArray list = '[' + QByteArray(quoted.data(), qsizetype(quoted.size())) + ']';
    return QJsonDocument::fromJson(list).array().at(0).toString().toStdString();
}

} // namespace

std::optional<RepeatedKey> repeatedKey(std::string_view json)
{
    std::vector<std::set<std::string>> open; // keys so far, of each object around this place
    for (std::size_t at = json.find_first_of("{}\""); at < json.size();
         at = json.find_first_of("{}\"", at)) {
        if (json[at] == '{')
            open.emplace_back();
        if (json[at] == '}' && !open.empty())
            open.pop_back();
        if (json[at] != '"') {
            ++at;
            continue;
        }
        const std::size_t begin = at;
        at = endOfText(json, begin);
        if (open.empty() || !isKey(json, at))
            continue;
        std::string key = meaning(json.substr(begin, at - begin));
        if (!open.back().insert(key).second)
            return RepeatedKey{std::move(key), begin};
    }
    return std::nullopt;
}

} // namespace fff::io
