#include "core/io/json_syntax.h"

#include "core/io/json_keys.h"
#include "core/io/loaded_document.h"

#include <QtCore/QCoreApplication>
#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>

namespace fff::io {

namespace {

bool isTokenCharacter(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '+' || c == '-' || c == '.' ||
           c == '_';
}

/// The word or number around `offset`, where Qt's parser gave up somewhere in or behind it; else
/// the next character that is not a blank.
std::string_view tokenAt(std::string_view text, std::size_t offset)
{
    std::size_t begin = std::min(offset, text.size());
    while (begin > 0 && isTokenCharacter(text[begin - 1]))
        --begin;
    std::size_t end = begin;
    while (end < text.size() && isTokenCharacter(text[end]))
        ++end;
    if (begin < end)
        return text.substr(begin, end - begin);
    const std::size_t next = text.find_first_not_of(" \t\r\n", begin);
    return next == std::string_view::npos ? std::string_view() : text.substr(next, 1);
}

/// Words that other programs write for what is no number, and numbers that no double can hold.
bool isNonFinite(std::string_view token)
{
    double value = 0.0;
    if (!token.empty() && token.front() == '+')
        token.remove_prefix(1);
    const char *end = token.data() + token.size();
    const auto [stop, error] = std::from_chars(token.data(), end, value);
    const bool isTiny =
        token.find("e-") != std::string_view::npos || token.find("E-") != std::string_view::npos;
    return stop == end && (error == std::errc::result_out_of_range
                               ? !isTiny
                               : error == std::errc() && !std::isfinite(value));
}

const char *expectedBy(QJsonParseError::ParseError error)
{
    switch (error) {
    case QJsonParseError::UnterminatedObject:
        return QT_TRANSLATE_NOOP("Error", "a name in quotes or the end of the object");
    case QJsonParseError::MissingNameSeparator:
        return QT_TRANSLATE_NOOP("Error", "a colon");
    case QJsonParseError::UnterminatedArray:
    case QJsonParseError::MissingValueSeparator:
        return QT_TRANSLATE_NOOP("Error", "a comma or the end of the list");
    case QJsonParseError::IllegalNumber:
    case QJsonParseError::TerminationByNumber:
        return QT_TRANSLATE_NOOP("Error", "a number");
    case QJsonParseError::IllegalEscapeSequence:
        return QT_TRANSLATE_NOOP("Error", "an escape sequence of JSON");
    case QJsonParseError::IllegalUTF8String:
        return QT_TRANSLATE_NOOP("Error", "text in UTF-8");
    case QJsonParseError::UnterminatedString:
        return QT_TRANSLATE_NOOP("Error", "the end of the text in quotes");
    case QJsonParseError::MissingObject:
        return QT_TRANSLATE_NOOP("Error", "another value after the comma");
    case QJsonParseError::DeepNesting:
        return QT_TRANSLATE_NOOP("Error", "no more than 1024 levels");
    case QJsonParseError::DocumentTooLarge:
        return QT_TRANSLATE_NOOP("Error", "a smaller file");
    case QJsonParseError::GarbageAtEnd:
        return QT_TRANSLATE_NOOP("Error", "the end of the file");
    case QJsonParseError::IllegalValue:
    case QJsonParseError::NoError:
        break;
    }
    return QT_TRANSLATE_NOOP("Error", "a value");
}

/// Nothing but the start of a word, such as "tru", follows: the file was cut off.
bool endsInToken(std::string_view rest)
{
    return std::all_of(rest.begin(), rest.end(), isTokenCharacter);
}

/// The four digits behind "\\u" at this place, if that is what stands there.
std::optional<unsigned> escapedUnit(std::string_view text, std::size_t at)
{
    unsigned unit = 0;
    const std::string_view digits = text.substr(std::min(at + 2, text.size()), 4);
    const bool isEscape = text.substr(std::min(at, text.size()), 2) == "\\u" && digits.size() == 4;
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), unit, 16);
    return isEscape && error == std::errc() && end == digits.data() + digits.size()
               ? std::optional(unit)
               : std::nullopt;
}

/// Where an escape sequence is one half of a character without the other; npos: nowhere. Of what is
/// JSON otherwise: backslashes stand in texts only.
std::size_t halfCharacter(std::string_view text)
{
    std::size_t at = text.find('\\');
    while (at != std::string_view::npos) {
        const std::optional<unsigned> unit = escapedUnit(text, at);
        std::size_t length = unit ? 6 : 2;
        const bool isFirst = unit && *unit >= 0xD800u && *unit < 0xDC00u;
        const bool isSecond = unit && *unit >= 0xDC00u && *unit < 0xE000u;
        if (isFirst) {
            const std::optional<unsigned> other = escapedUnit(text, at + length);
            if (!other || *other < 0xDC00u || *other >= 0xE000u)
                return at;
            length *= 2;
        }
        if (isSecond)
            return at;
        at = text.find('\\', at + length);
    }
    return at;
}

std::string lineAt(std::string_view text, std::size_t offset)
{
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(offset);
    return std::to_string(1 + std::count(text.begin(), end, '\n'));
}

bool checkKeys(std::string_view json, Problems &problems)
{
    const std::optional<RepeatedKey> repeated = repeatedKey(json);
    if (repeated)
        problems.fail(ErrorCode::BadSyntax, lineAt(json, repeated->at),
                      {io::quoted(repeated->key),
                       QT_TRANSLATE_NOOP("Error", "each key of an object only once")});
    return !repeated;
}

} // namespace

bool checkCharacters(std::string_view json, Problems &problems)
{
    const std::size_t half = halfCharacter(json);
    if (half == std::string_view::npos)
        return true;
    problems.fail(ErrorCode::BadSyntax, lineAt(json, half),
                  {io::quoted(json.substr(half, 6)),
                   QT_TRANSLATE_NOOP("Error", "both halves of a character")});
    return false;
}

QJsonDocument parseJson(std::string_view bytes, Problems &problems)
{
    bytes = withoutByteOrderMark(bytes);
    const std::size_t last = bytes.find_last_not_of(" \t\r\n");
    const std::string_view text = bytes.substr(0, last == std::string_view::npos ? 0 : last + 1);

    QJsonParseError error;
    const QJsonDocument json = QJsonDocument::fromJson(
        QByteArray::fromRawData(text.data(), static_cast<qsizetype>(text.size())), &error);
    if (error.error == QJsonParseError::NoError)
        return checkCharacters(text, problems) && checkKeys(text, problems) ? json
                                                                            : QJsonDocument();

    const std::size_t offset =
        std::min(static_cast<std::size_t>(std::max(error.offset, 0)), text.size());
    const std::string where = lineAt(text, offset);
    const std::string_view token = tokenAt(text, offset);
    const char *expected = expectedBy(error.error);
    if (isNonFinite(token))
        problems.fail(ErrorCode::NonFinite, where, {io::quoted(token)});
    else if (error.error != QJsonParseError::DeepNesting &&
             error.error != QJsonParseError::GarbageAtEnd && endsInToken(text.substr(offset)))
        problems.fail(ErrorCode::Truncated, where, {expected});
    else
        problems.fail(ErrorCode::BadSyntax, where, {io::quoted(token), expected});
    return {};
}

} // namespace fff::io
