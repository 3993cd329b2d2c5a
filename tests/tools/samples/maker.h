// What the samples are made with: a document that grows section by section and operation by
// operation. The program ends at the first mistake, since nobody waits for it.
#pragma once

#include "core/geometry/figure.h"
#include "core/model/document.h"
#include "core/model/mark.h"

#include <map>
#include <string>
#include <vector>

namespace fff::samples {

using Inputs = std::map<std::string, std::vector<SectionRef>>; // by role
using Values = std::map<std::string, ParameterValue>;          // by key, numbers as in the file

/// What whoever adjusts a sample sees: a slider, a counter or a text. Numbers as they are typed,
/// mm, degrees or plain.
struct Adjustable
{
    std::string name;
    ValueKind kind = ValueKind::Length;
    std::string typed;
    double least = 0.0, most = 0.0, step = 1.0; // of numbers
    std::string note = {};
};

class Maker
{
public:
    /// Of plates this thick, mm.
    explicit Maker(double thickness = 3.0);
    /// Of plates of this stock.
    explicit Maker(Stock stock);

    SectionRef add(const std::string &name, const Frame &frame, Contour contour,
                   std::vector<Contour> holes = {});
    /// The same, as if drawn on `parent`: the slit there is the longest stretch in which they meet.
    SectionRef addOn(const SectionRef &parent, const std::string &name, const Frame &frame,
                     Contour contour, std::vector<Contour> holes = {});
    /// A boundary that stays a shape by numbers: 0 is the contour.
    SectionRef addFigures(const std::string &name, const Frame &frame, const Figure &contour,
                          const std::vector<Figure> &holes = {});
    /// Words on a section, which are its mark of that number from 0 on.
    void write(const SectionRef &section, const Lettering &words);
    OperationId apply(const std::string &kind, const std::string &name, const Inputs &inputs,
                      const Values &values = {});
    /// One of its sections is not made.
    void hide(OperationId operation, const std::string &key);
    /// In their joint the slit of `a` opens that way, in its frame coordinates.
    void open(const SectionRef &a, const SectionRef &b, const Vec2 &way);
    void hang(const SectionRef &section, const Vec2 &position, double kilograms);
    /// Of the weight what is not its place.
    void put(const SectionRef &section, const Vec2 &position, Load weight);

    void show(const Adjustable &value);
    /// A value of others, with a note on what it is; nobody is asked for it.
    void derive(const std::string &name, ValueKind kind, const std::string &typed,
                const std::string &note);
    /// What is typed for values that are shown, by their names; of the others as it is.
    void preset(const std::string &name, const std::map<std::string, std::string> &typed);
    /// The number of a section, an operation, … follows an expression: width, height, angle, x, y
    /// and z of a section are those of the box of its contour.
    void drive(const SectionRef &section, const std::string &field, const std::string &typed);
    void drive(OperationId operation, const std::string &key, const std::string &typed);
    void driveFigure(const SectionRef &section, int boundary, const std::string &number,
                     const std::string &typed);
    void driveWords(const SectionRef &section, int mark, const std::string &field,
                    const std::string &typed);
    /// Of the load that was put last.
    void driveLoad(const std::string &field, const std::string &typed);

    /// The middle of the box of a drawn section's contour, in the world, as `drive` means it.
    Vec3 middleOf(const SectionRef &section) const;
    /// All that is there by now, drawn or made.
    std::vector<SectionPointer> sections() const;
    void write(const std::string &folder, const std::string &name) const;

private:
    void driveAt(const std::string &place, const std::string &typed);

    Document m_document;
};

/// As it is typed into an expression, to 0.001 mm: "12.5 mm".
std::string millimetres(double length);

// Planes. In the upright ones, local coordinates are across and up.
Frame facingFront(double z);
Frame facingRight(double x); // across runs to the back
Frame lying(double y);       // across runs to the right, up to the back
Frame radial(double angle);  // across runs outwards from the middle

} // namespace fff::samples
