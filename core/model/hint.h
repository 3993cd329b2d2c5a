// What the next click or drag does, or why one came to nothing.
#pragma once

#include "core/base/message.h"

#include <utility>

namespace fff {

/// Its texts stand with what says them (…_words.h), in the namespace hints. They may have the marks
/// of rich text; names in them are written bold.
struct Hint
{
    Message words;
    bool isRefusal = false;  // amber, stays for 6 s or until the next press
    bool offersUndo = false; // something was done that may not be wanted: how it is taken back
    bool isOfView = false;   // the view alone is moved

    Hint() = default;
    Hint(Message message) : words(std::move(message)) {}
    Hint(Text text, std::vector<Argument> arguments = {}) : words{text, std::move(arguments)} {}
    static Hint ofView(Text text)
    {
        Hint hint(text);
        hint.isOfView = true;
        return hint;
    }
    static Hint undoable(Text text)
    {
        Hint hint(text);
        hint.offersUndo = true;
        return hint;
    }
    static Hint refusal(Text text, std::vector<Argument> arguments = {})
    {
        Hint hint(text, std::move(arguments));
        hint.isRefusal = true;
        return hint;
    }

    bool operator==(const Hint &) const = default;
};

/// Why an edit is not made.
inline tl::unexpected<Hint> refused(Text text, std::vector<Argument> arguments = {})
{
    return tl::unexpected<Hint>(Hint::refusal(text, std::move(arguments)));
}

} // namespace fff
