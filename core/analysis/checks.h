// What a person wants to know about a model before cutting it, as verdicts: does it hold together,
// does it stand, does it fit the sheet, can it be put together. Pure data; the sentences are made
// in check_text.h.
#pragma once

#include "core/analysis/check_caches.h"
#include "core/assembly/slits.h"
#include "core/fabrication/summary.h"
#include "core/model/joint_ref.h"

#include <chrono>
#include <optional>
#include <vector>

namespace fff {

/// What was found. The names of what can be wrong are published (check_text.h).
enum class CheckCode {
    // subject Connection
    Connected,
    NotConnected, // a group of sections that nothing holds to the largest group; one check a group
    // subject Stability
    Stands,
    Unsteady, // stands, but tips when tilted by less than kSteadyTilt
    Topples,
    LineSupport, // falls to either side
    NoContact,   // hangs above the ground
    BelowGround, // reaches below the ground
    // subject Size
    FitsSheet,
    TooLarge, // one check a section with such a part
    // subject Mass
    Mass,
    // subject Assembly (plan_checks.h)
    CanAssemble,
    CannotAssemble, // parts that block each other
    OrderUnknown,   // not found within the time
    // subject Joints; only when there is something to say
    NoSlit,       // two sections cut into each other, but no slit lets them slide together
    Interference, // two sections cut into each other where no joint is (plan_checks.h)
    ShallowAngle, // two sections meet at less than that (CheckRules), or, as an error, at less than
                  // any joint takes (kMinJointAngle)
    Cycle,       // sections form rings of joints that slide in different directions (plan_checks.h)
    SlitsMeet,   // two slits of a section run into each other (plan_checks.h)
    ThinWeb,     // less than the stock's thickness stays beside a slit (plan_checks.h)
    NarrowSlit,  // narrower than the tool that is to cut it, or, as an error, closed by the
                 // kerf (narrow_slits.h)
    Divided,     // its slits divide a section into several parts
    NothingLeft, // its slits leave nothing of a section
    NotCutOut,   // what they leave could not be worked out; all else counts it without them
    NotMade,     // an operation's sections could not be worked out
    // subject Assembly, of the plan; else Joints
    NotWorkedOut, // a stage failed, or was stopped (core/session/check_list.h)
};

/// A badge speaks about a subject; its severity is the worst of that subject's checks.
enum class CheckSubject { Connection, Stability, Assembly, Size, Mass, Joints };

enum class CheckSeverity { Good, Unknown, Note, Warning, Error }; // ordered

/// As seen in the front view: the front is +Z, the right +X.
enum class Towards { Front, Back, Left, Right };

/// Two sections that are in each other's way, and where.
struct CheckLink
{
    SectionRef a, b;
    Vec3 fromA = Vec3::Zero(), fromB = Vec3::Zero(); // a place on each of them, world, mm
    Vec3 at = Vec3::Zero();  // their joint, or where the first comes to stand against the other
    Vec3 way = Vec3::Zero(); // in which their joint slides, unit; zero: no joint

    bool operator==(const CheckLink &other) const
    {
        return a == other.a && b == other.b && fromA == other.fromA && fromB == other.fromB &&
               at == other.at && way == other.way;
    }
};

/// A section that ends above the ground and would help to stand there.
struct HighFoot
{
    SectionRef section;
    double height = 0.0;    // of its lowest point above the ground, mm
    Vec3 at = Vec3::Zero(); // that point, world, mm

    bool operator==(const HighFoot &other) const
    {
        return section == other.section && height == other.height && at == other.at;
    }
};

struct Check
{
    CheckCode code = CheckCode::Connected;
    CheckSeverity severity = CheckSeverity::Good;
    std::vector<SectionRef> sections; // whom it is about; empty: the whole model.
                                      // BelowGround: those that reach below
    std::optional<SectionRef> other;  // NotConnected: who is nearest
    std::vector<SectionRef> guests; // SlitsMeet, ThinWeb: whom the section's one or two slits hold
    std::optional<Vec3> at;         // where to look, world, mm
    std::optional<JointRef> joint;  // that it is about, where it is about one
    std::optional<Error> failure;   // NotCutOut, NotMade, NotWorkedOut, and OrderUnknown where it
                                    // is not for time
    const char *stage = nullptr;    // NotWorkedOut: its name
    std::vector<CheckLink> links;   // CannotAssemble, Cycle: who blocks whom
    std::vector<HighFoot> feet;     // Topples, LineSupport: who would hold it up on the ground, if
                                    // there are such (stretching.h)

    // The numbers of its sentence; 0 where the code has no use for them.
    double margin = 0.0;   // Stability: mm from the centre of mass to the support's nearest edge,
                           // negative outside. TooLarge: what the sheet's edges leave free
    double tipAngle = 0.0; // Stands, Unsteady: radians up to which it can be tilted
    Polygon support;       // Stability: of what stands or falls, (x, z); see stability.h
    Vec2 edge = Vec2::Zero(); // Stability: (x, z), of its boundary nearest to the centre of mass
    Towards side = Towards::Front; // Stability: where to it falls, or would first
    double distance = 0.0;    // mm. NotConnected: to the nearest other section (negative: unknown);
                              // NoContact: above the ground; BelowGround: below it (both positive);
                              // NoSlit: the longest overlap; Interference: how deep;
                              // CannotAssemble: how far the first section comes out of the second
                              // one, 0: it is not that; ThinWeb: what stays;
                              // NarrowSlit: its width
    double tool = 0.0;        // NarrowSlit: the tool's diameter, or the kerf, mm
    double angle = 0.0;       // ShallowAngle: radians
    double leastAngle = 0.0;  // ShallowAngle: below which it is said, radians
    Vec2 size = Vec2::Zero(); // TooLarge: the part as designed, its longer side first, mm
    Vec2 sheet = Vec2::Zero(); // FitsSheet (one stock only), TooLarge: the sheet's size, mm
    int sectionCount = 0;      // Connected: all; Stands: those that stand
    int count = 0; // Connected: joints; FitsSheet: sheets; Divided: parts; TooLarge: parts
                   // of that section that do not fit; CanAssemble: steps; CannotAssemble:
                   // joints of those that block each other; Interference: joints of the two;
                   // ThinWeb: holes that it is beside, 0 or 1
    NoSlit noSlit = NoSlit::Enclosed; // NoSlit: why
    int directions = 0;               // CannotAssemble: in which those joints slide
    double share = 0.0;               // FitsSheet: of the sheets' area that parts cover, 0 … 1
    MassProperties mass; // Mass: kg, and its centre; Stability: of what stands or falls
};

/// Tilted by less than this, something that stands ought not to fall: 10°, as for household
/// equipment (IEC 62368-1, stability). Radians.
inline constexpr double kSteadyTilt = 0.17453292519943295;
/// What a person wants of the checks.
struct CheckRules
{
    double shallowAngle = 0.52359877559829887; // radians, 30°: slits get wide below this
    std::chrono::milliseconds planningTime{1000};

    bool operator==(const CheckRules &) const = default;
};

CheckSubject subjectOf(CheckCode code);
CheckSubject subjectOf(const Check &check);
/// Whom it is about: its sections and its feet.
std::vector<SectionRef> concerned(const Check &check);

/// The checks of a model, but those that take planning: of each subject at least one (Joints: only
/// what is wrong), in the order of the subjects and, within one, of the sections. A model that is
/// not connected says so first; each of its groups then stands or falls by itself, and those that
/// hang in the air because nothing holds them are not named a second time. Nothing for a model
/// without sections.
///
/// Deterministic. Costs what a layout does; for a worker, not for the window's thread.
std::vector<Check> checks(const Analysis &analysis, const LayoutOptions &layout = {},
                          const CheckRules &rules = {});

/// As from scratch, with any caches.
std::vector<Check> checks(const Analysis &analysis, CheckCaches &caches,
                          const LayoutOptions &layout = {}, const CheckRules &rules = {});

/// The worst of a subject, nothing when it has none.
std::optional<CheckSeverity> worst(const std::vector<Check> &checks, CheckSubject subject);

/// Of sections (indices into the model), with the weights that hang on them.
MassProperties loadedMass(const Analysis &analysis, const std::vector<int> &sections);

/// Whether and how the sections (indices into the model) stand, taken as one rigid body with the
/// weights that hang on them.
Stability stabilityOf(const Analysis &analysis, const std::vector<int> &sections);

} // namespace fff
