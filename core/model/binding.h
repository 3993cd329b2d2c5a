// A number of a document that follows what was typed for it: "2*gap", "Shelf {n}".
#pragma once

#include "core/model/section.h"
#include "core/values/typed.h"

#include <compare>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace fff {

/// Which number, switch, choice or text of a document: whose it is, and which of its fields
/// (core/operations/drivable.h).
struct DrivenPlace
{
    enum class Of {
        Stock,
        Operation,
        Section,
        Figure,    // index: the boundary of the section that it is (core/model/figures.h)
        Lettering, // index: of the section's marks
        Load,
        Joint, // of sections a < b; index: of its shares
        Dimension,
    };
    Of of = Of::Stock;
    std::int64_t id = 0; // of the stock, operation, section, load or dimension; of a joint 0
    SectionRef a = {}, b = {};
    int index = 0;
    std::string field;

    bool operator==(const DrivenPlace &) const = default;
    std::strong_ordering operator<=>(const DrivenPlace &) const = default;
};

/// The number stands where it always stood; beside it is kept of what it is made, and what that
/// came to last. It counts as long as the number is just that: whoever sets it, by hand or by any
/// edit, ends the binding, and need not know of it.
struct Binding
{
    DrivenPlace place;
    ValueKind kind = ValueKind::Number; // as the place wants it
    std::string typed;
    Reading reading;
    Worth result; // mm, radians, kg, or plain

    bool operator==(const Binding &) const = default;
};

/// A binding, and what was typed as it was read, once.
struct KnownBinding
{
    Binding binding;
    Understood<Typed> typed;
};
using BindingPointer = std::shared_ptr<const KnownBinding>;

BindingPointer makeBinding(Binding binding);

/// Whether the number is what the expression came to: to rounding of a few turns and moves.
bool isSameWorth(const Worth &a, const Worth &b);

} // namespace fff
