// What the program calls sections that nobody has named, in the language of whoever draws. A name
// is the document's from then on: it is never translated again.
#pragma once

#include "core/model/document.h"

#include <string>
#include <unordered_set>
#include <vector>

namespace fff {

/// Patterns, UTF-8: "%1" stands for the number.
struct Naming
{
    std::string section = "Section %1";
    /// What others call theirs, in other languages: their numbers are taken as well.
    std::vector<std::string> others = {};
};

/// The pattern with this number in it; one without a place for it gets it behind a blank.
std::string numberedName(const std::string &pattern, std::size_t number);

/// Gives names to sections that come to a document one after the other: each costs the same,
/// however many there are.
class SectionNames
{
public:
    SectionNames(const Document &document, Naming naming);

    /// As freeSectionName() gives it to the document with all that were named here.
    std::string next();

private:
    bool isTaken(const std::string &pattern, std::size_t number) const;

    Naming m_naming;
    std::unordered_set<std::string> m_names;
    std::size_t m_count; // of sections
};

/// The section's pattern with the smallest number above the number of sections that no section has
/// by this pattern or one of the others.
std::string freeSectionName(const Document &document, const Naming &naming = {});

/// Of `count` sections that are called after one thing: its word where there is one and nobody has
/// that name, else "word 1", "word 2" …, leaving out what is taken. None after an empty word.
std::vector<std::string> namesAfter(const Document &document, const std::string &word,
                                    std::size_t count);

} // namespace fff
