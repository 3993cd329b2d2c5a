// What the operations of a document came to. Derived from it, never saved; unchanged results are
// shared from one model to the next (core/operations/evaluate.h).
#pragma once

#include "core/geometry/halfplane_clip.h"
#include "core/model/binding.h"
#include "core/model/operation.h"
#include "core/model/stock.h"
#include "core/model/template.h"
#include "core/values/evaluated_values.h"

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace fff {

/// What there is to say of an operation's result.
struct OperationNotice
{
    enum class Kind {
        InputMissing, // it makes nothing; name: what the section was called, empty: none was chosen
        InputsApart,  // the sections do not meet where they have to; it makes nothing
        NothingFits,  // within its range nothing can be made
        NothingToDo,  // its section is as it is to be; it stays so
        StoppedAtMost, // the number of sections that may be made was reached; count: that number
        LeftOut,       // count: of sections that could not be made
        NoTemplate,    // it is of one that is not there; it makes nothing
        Slivers,       // count: of pieces that are too small to be worth a section
        Failed         // what it would make could not be worked out: the model is not whole
    };
    Kind kind = Kind::InputMissing;
    std::string role = {}; // InputMissing: of the input
    std::string name = {};
    int count = 0;

    bool operator==(const OperationNotice &) const = default;
};

/// What one operation made, and all that it looked at for that.
struct OperationResult
{
    OperationPointer operation;

    /// In the order of their keys (isKeyBefore), without those that exceptions take out.
    std::vector<SectionPointer> sections;
    /// Of sections that are images of others (symmetry): of which, and whether the world is
    /// mirrored between them. Frame coordinates are the same in both.
    struct Image
    {
        SectionRef of;
        bool isMirrored = false;
    };
    std::map<std::string, Image> images; // by their keys
    /// Of sections that lie across a mirror, and are symmetric by that: its line, in their frames.
    std::map<SectionRef, Halfplane> mirrors;
    /// Sections from above that it makes other ones of; null: that it takes the place of.
    std::vector<std::pair<SectionRef, SectionPointer>> changed;
    std::vector<OperationNotice> notices;
    /// Of parameters that follow from the inputs: what they are.
    std::map<std::string, double> found;
    /// Where handles of parameters go: points in the world and the values there, ascending. Empty:
    /// nowhere.
    std::vector<std::pair<Vec3, double>> track;

    /// The sections as it saw them; null: it was not there.
    std::vector<std::pair<SectionRef, SectionPointer>> readSections;
    std::vector<std::pair<StockId, std::shared_ptr<const Stock>>> readStocks;
    /// The template that it is of, as it saw it; null: it was not there, or none is wanted.
    TemplatePointer readTemplate;
    /// Not null: it saw all sections above it, which were these.
    std::shared_ptr<const std::vector<SectionPointer>> readAll;
};

using OperationResultPointer = std::shared_ptr<const OperationResult>;

/// All sections of a model in one order.
struct Listing
{
    /// Those from begin to end are an operation's.
    struct Block
    {
        OperationId operation;
        std::size_t begin = 0, end = 0;

        bool operator==(const Block &) const = default;
    };
    std::vector<SectionPointer> sections; // the drawn ones as in the document, then the blocks
    std::vector<Block> blocks;            // in the order of the operations
    std::size_t drawn = 0;                // so many of the sections are
};

/// Where the section of this key is among those that one operation made, which are in the order of
/// their keys; -1: nowhere.
int indexOfKey(const std::vector<SectionPointer> &sections, const std::string &key);

/// Why a number does not follow what was typed for it, in one sentence.
struct DrivingError
{
    DrivenPlace place;
    Message sentence;

    bool operator==(const DrivingError &) const = default;
};

struct Evaluation
{
    EvaluatedValues values; // what the document's come to
    /// Not empty: no number of the document was changed, all are as they were before.
    std::vector<DrivingError> drivingErrors;
    std::vector<OperationResultPointer> results; // one an operation that is on, in their order
    /// Null: no operation makes or changes anything, the sections are those of the document.
    std::shared_ptr<const Listing> listing;
};

} // namespace fff
