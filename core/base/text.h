// Texts of this program that are translated where they are shown: the window and the command line
// do that, core knows no Qt. translations/update finds them by the names of these macros.
#pragma once

namespace fff {

/// Of a context, as Qt has it: a file's or a feature's texts have one.
struct Text
{
    const char *context = nullptr; // null: it is the same in every language
    const char *source = nullptr;  // English; the text itself
};

bool operator==(const Text &a, const Text &b);

} // namespace fff

/// Both are literals. Translators read the comment before it, which begins with "//:".
#define FFF_TEXT(context, source)                                                                  \
    ::fff::Text                                                                                    \
    {                                                                                              \
        context, source                                                                            \
    }
/// One that has a number: with %n, which has a plural of its own in each language.
#define FFF_TEXT_OF_MANY(context, source) FFF_TEXT(context, source)

// Qt's own macro does the same; for tables that have their context elsewhere.
#ifndef QT_TRANSLATE_NOOP
#define QT_TRANSLATE_NOOP(context, text) text
#endif
