// Failures of geometry and files are data: every function that can fail for such a reason returns a
// Result. The words a person reads are made from the code in ui and the command line
// (core/io/error_text.h).
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace fff {

enum class ErrorCode {
    CannotOpen,   // args: reason of the system
    CannotWrite,  // args: reason of the system
    NotAModel,    // the file is of no kind that we read
    NewerVersion, // args: version of the file, newest that we read
    Truncated,    // the file ends early; args: what was expected
    BadSyntax,    // args: what was found, what was expected
    BadValue,     // a value of the wrong type or out of its range; args: what was found, what was
                  // expected
    NonFinite,    // nan or infinity; args: what was found
    BadCount,     // a count that no real file has; args: the count, the largest allowed
    DegenerateFrame,  // the axes of a frame have no length or no plane
    EmptyContour,     // a contour that encloses no area
    BadContour,       // wrong number of control points; args: found, expected
    UnknownReference, // an id that names nothing; args: the id
    DuplicateId,      // args: the id
    NearlyParallel,   // two planes meet at less than kMinJointAngle
    SelfCrossing,     // a contour crosses itself where that is not allowed
    BoundariesMeet,   // a hole meets the contour or another hole, or leaves the contour
    TooFewPoints,     // a contour would keep too few control points to enclose anything
    CannotOffset,     // no path runs round an outline at the kerf's half everywhere; args: section,
                      // kerf
    ClosedSlit,       // a slit that the kerf closes; args: section, the slit's width, the kerf
    NothingToExport,  // no section, so no part; args: a section, where slits leave nothing of any
    NoSkin,           // of a model; args: where contours cross, how many places cannot be covered
    UnknownCommand,   // args: the command's id
    BadEvent,         // an event that makes no sense here; args: what, what was expected
    Unsupported,      // args: what
    NotWorkedOut,     // a geometric construction failed on input that is in order
    NotCutOut,        // a section whose parts cannot be told; args: its name
    NotSolid,         // a section whose solid cannot be told; args: its name
    MarksNotCut,      // marks that cannot be cut off at the section's edge; args: its name
    OperationFailed,  // an operation whose sections cannot be told; args: its name
    StageFailed,      // what is derived from the model threw; args: what it said
    Cancelled,        // somebody stopped it
    BadArchive,       // what is packed in a file is not in order; args: what is wrong
};

/// place: where it went wrong: "file:line", a JSON path, a section's name, or empty.
struct Error
{
    ErrorCode code = ErrorCode::BadValue;
    std::string place;
    std::vector<std::string> args;

    bool operator==(const Error &) const = default;
};

template <class T>
using Result = tl::expected<T, Error>;

inline tl::unexpected<Error> failure(ErrorCode code, std::string place = {},
                                     std::vector<std::string> args = {})
{
    return tl::unexpected<Error>(Error{code, std::move(place), std::move(args)});
}

/// What was read but not quite as it stood: the model is complete, something in it was mended.
enum class WarningCode {
    SkewFrame,           // a frame was made orthonormal, its contour re-expressed
    SelfCrossingContour, // the largest non-zero region of a contour was kept
    HoleOutside,         // a hole that does not lie in its contour was left out
    DegenerateHole,      // a hole without area was left out
    MergedHoles,         // holes that overlap were made one
    NotchedContour,      // a hole that reaches out of its contour was cut out of it
    TrailingLines,       // text after the last section was ignored
    MissingBlob,         // a picture or the like was left out; args: its name, why
    MissingTemplate,     // a template keeps its place without what it shows; args: its name
    LostBinding,         // a number does not follow what was typed for it; args: that
};

struct Warning
{
    WarningCode code = WarningCode::SkewFrame;
    std::string place;
    std::vector<std::string> args;

    bool operator==(const Warning &) const = default;
};

} // namespace fff
