// What the samples are made with: a document that grows section by section and operation by
// operation. The program ends at the first mistake, since nobody waits for it.
#pragma once

#include "core/model/document.h"

#include <map>
#include <string>
#include <vector>

namespace fff::samples {

using Inputs = std::map<std::string, std::vector<SectionRef>>; // by role
using Values = std::map<std::string, ParameterValue>;          // by key, numbers as in the file

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
    OperationId apply(const std::string &kind, const std::string &name, const Inputs &inputs,
                      const Values &values = {});
    /// One of its sections is not made.
    void hide(OperationId operation, const std::string &key);
    /// In their joint the slit of `a` opens that way, in its frame coordinates.
    void open(const SectionRef &a, const SectionRef &b, const Vec2 &way);
    void hang(const SectionRef &section, const Vec2 &position, double kilograms);
    /// Of the weight what is not its place.
    void put(const SectionRef &section, const Vec2 &position, Load weight);

    /// All that is there by now, drawn or made.
    std::vector<SectionPointer> sections() const;
    void write(const std::string &folder, const std::string &name) const;

private:
    Document m_document;
};

// Planes. In the upright ones, local coordinates are across and up.
Frame facingFront(double z);
Frame facingRight(double x); // across runs to the back
Frame lying(double y);       // across runs to the right, up to the back
Frame radial(double angle);  // across runs outwards from the middle

} // namespace fff::samples
