// The document: a value, cheap to copy, never changed in place (edits.h makes the next one).
#pragma once

#include "core/model/binding.h"
#include "core/model/blob.h"
#include "core/model/dimension.h"
#include "core/model/joint_override.h"
#include "core/model/load.h"
#include "core/model/named_number.h"
#include "core/model/operation.h"
#include "core/model/section.h"
#include "core/model/sheet_wishes.h"
#include "core/model/stock.h"
#include "core/model/template.h"
#include "core/values/values.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace fff {

/// Order of `sections` is that of drawing. Every section's stock is in `stocks`; `currentStock` is
/// that of the next section. `nextId` is larger than every id ever given here.
struct Document
{
    std::vector<SectionPointer> sections;
    std::vector<std::shared_ptr<const Stock>> stocks;
    std::vector<OperationPointer> operations; // in the order in which they work
    std::vector<Load> loads;
    std::vector<JointOverridePointer> jointOverrides; // ascending in (a, b), none of them empty
    std::vector<Dimension> dimensions;
    std::vector<PinnedPlace> pins;          // ascending by section and body, each part once
    std::vector<SectionTurning> turnings;   // ascending by section, each once
    std::vector<NamedNumber> numbers;       // by which numbers can be called in fields
    Values values;                          // with names, of which numbers are made
    std::vector<BindingPointer> bindings;   // ascending by place, each place once
    std::vector<TemplatePointer> templates; // as they are listed
    std::vector<BlobPointer> blobs;         // ascending by sha256, each once
    StockId currentStock;
    std::int64_t nextId = 1;
    bool opensForAdjusting = false; // a window has its shown values, the view and Export, no more

    /// In `sections`, or -1. Ids rise in the order of drawing, where it takes O(log sections); a
    /// file may have them in another order, where it takes O(sections).
    int indexOf(SectionId id) const;
    /// Null when there is none.
    const Section *find(SectionId id) const;
    const Stock *find(StockId id) const;
    const Operation *find(OperationId id) const;
    const Load *find(LoadId id) const;
    const Template *find(TemplateId id) const;
    const Blob *findBlob(std::string_view sha256) const;
    /// Of two sections in any order, or null. O(log overrides).
    const JointOverride *jointOverride(const SectionRef &first, const SectionRef &second) const;
    /// Of a section of this document.
    const Stock &stockOf(const Section &section) const;

    /// Same objects (pointers), not same values: what "nothing changed" means for undo and
    /// redrawing.
    bool isSame(const Document &other) const;
    /// Same values: what a file that was written and read again must show.
    bool operator==(const Document &other) const;
};

/// An empty document with birch plywood.
Document newDocument();

} // namespace fff
