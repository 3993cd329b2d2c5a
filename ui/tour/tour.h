// "Your first model in 3 minutes": seven steps that wait for what a person does, in order. It knows
// nothing of how they are shown (tour_guide.h), and never does anything by itself.
#pragma once

#include <QObject> // first: moc stumbles over some standard headers

#include "core/interaction/camera.h"

#include <optional>
#include <set>
#include <vector>

namespace fff {
struct Model;
struct Section;
} // namespace fff

namespace fff::ui {

class Workbench;

/// The first section that is large enough to draw another one across it: a line across a hand at
/// least, and no strip of waste. Null: there is none.
const Section *bodyOf(const Model &model);

class Tour : public QObject
{
    Q_OBJECT
public:
    enum class Step { Draw, Cross, Turn, Thickness, Check, Repeat, Export };

    explicit Tour(Workbench &bench, QObject *parent = nullptr);

    /// canRepeat  whether operations are there: without them that step is left out
    void begin(bool canRepeat);
    /// Before its end or after it.
    void end();
    /// On to the next step, with nothing done.
    void skip();

    bool isOn() const { return m_isOn; }
    /// All is done, and the last words stand there.
    bool isDone() const { return m_isOn && m_at == m_steps.size(); }
    /// What is to be done now: to draw the body, where it was undone. Only while it is not done.
    Step step() const;
    /// It waits for one of the first two sections: what is wrong with one alone is none of its
    /// fault.
    bool isWaitingForSections() const;
    /// It does so although one has just been drawn, which is too small to go on with.
    bool isTooSmall() const;
    /// At the end: nothing was left out.
    bool hasDoneAll() const { return m_skipped.empty(); }
    /// From 0 on.
    int number() const;
    int count() const { return static_cast<int>(m_steps.size()); }

    // What is done elsewhere in the window than in its model and view.
    void verdictRead() { did(Step::Check); }
    void exported() { did(Step::Export); }
    /// Somebody has looked at it, and it may be right as it is.
    void thicknessSeen() { did(Step::Thickness); }
    /// Operations are not there any more.
    void leaveOutRepeat();

Q_SIGNALS:
    void changed();

private:
    void did(Step step);
    void goOn();
    bool lacksBody() const;
    void followModel();
    void followView();

    Workbench &m_bench;
    std::vector<Step> m_steps;
    std::size_t m_at = 0;
    bool m_isOn = false;
    bool m_hadBody = false;   // to go on with
    std::set<Step> m_done;    // also before its turn
    std::set<Step> m_skipped; // of those that are behind; done later, one is taken back
    // As the tour began.
    std::size_t m_operations = 0;
    std::vector<double> m_thicknesses;
    std::optional<Camera> m_camera; // as the step began; none yet while the view moves by itself
};

} // namespace fff::ui
