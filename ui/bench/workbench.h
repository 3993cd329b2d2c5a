// What the parts of the window work on together: the session, the interaction that edits it, and
// the selection. Interaction is plain C++; this says with signals what changed in it.
#pragma once

#include "core/analysis/problem_look.h"
#include "core/analysis/trial.h"
#include "core/analysis/weak_place.h"
#include "core/assembly/joint_editing.h"
#include "core/geometry/polygon.h"
#include "core/interaction/commands.h"
#include "core/interaction/interaction.h"
#include "core/interaction/tool.h"
#include "core/session/session.h"
#include "core/session/session_host.h"
#include "ui/base/event_clock.h"

#include <QObject>

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace fff {
class SheetNesting;
}

namespace fff::ui {

class Workbench : public QObject
{
    Q_OBJECT
public:
    explicit Workbench(QObject *parent = nullptr);
    ~Workbench() override;

    Session &session() { return m_session; }
    const Session &session() const { return m_session; }
    /// How parts lie on their sheets, for whoever shows or writes that.
    SheetNesting &nesting() { return *m_nesting; }
    /// To look at; what changes it goes through the functions below.
    const Interaction &interaction() const { return *m_interaction; }

    void setViewport(const Vec2 &size);
    /// What stands over the view, and what it shows besides sections (Interaction).
    void setCovered(std::vector<Box2> covered, const std::vector<Box2> &passing = {});
    void setSeenBesides(std::vector<Vec3> points);
    void handle(const PointerEvent &event);
    bool escape();
    /// Of the tool in the hand.
    bool wants(ToolKey key) const;
    bool key(ToolKey key);
    void setNumbers(const std::vector<ToolNumber> &numbers);
    void dropNumbers();
    /// Moves animations on; true while one runs.
    bool advance();
    EventClock &clock() { return m_clock; }

    /// The session's commands; the window adds its own.
    CommandRegistry &commands() { return m_commands; }
    const CommandRegistry &commands() const { return m_commands; }
    /// A failure is announced by editFailed.
    void run(const QString &id, const CommandParameters &parameters = {});

    void setCamera(const Camera &camera);
    /// The whole model from one of the standard views, at once; as soon as the view has a size.
    void showAll(std::string_view view);
    void select(std::vector<SectionRef> selection);
    void selectJoint(const JointRef &joint);
    void selectOperation(OperationId id);
    void selectLoad(LoadId id);

    // The view's state: what is hidden, red, isolated, cut open. No step of the history.
    bool isHidden(const SectionRef &ref) const { return m_interaction->view().isHidden(ref); }
    /// A hidden section is neither drawn nor picked.
    void setHidden(const SectionRef &ref, bool hidden) { setHidden(std::vector{ref}, hidden); }
    void setHidden(const std::vector<SectionRef> &sections, bool hidden);
    /// Numbers beside problems. A click on one is announced by problemChosen.
    void setProblemMarks(std::vector<ProblemMark> marks);
    /// What else is drawn of problems; the sections that are red and hatched, or outlined; and
    /// those of them that are amber.
    void setProblemLook(ProblemLook look, const std::vector<SectionRef> &hatched,
                        const std::vector<SectionRef> &outlined,
                        const std::vector<SectionRef> &doubtful);
    /// Empty while something else than the model is shown.
    const ProblemLook &problemLook() const { return m_areMarksAside ? m_noLook : m_look; }
    /// Put aside for as long as something else than the model is shown.
    void setMarksAside(bool aside);
    /// The joints of what is selected are read in a list: they are all marked in the view.
    void setListsJoints(bool lists);
    /// The mark that is shown as if the cursor were on it, because it is on its row; 0: none.
    void setLitProblem(int number);
    int litProblem() const { return m_litProblem; }

    /// Outlined as if the cursor were on them, sorted; those that are not there now are passed
    /// over. With them ghosts of sections that are not there now, or not as they are.
    void setOutlined(std::vector<SectionRef> sections, std::vector<SectionPointer> ghosts = {});
    const std::vector<SectionPointer> &ghosts() const { return m_tried ? m_wasThere : m_ghosts; }
    const std::vector<SectionRef> &outlined() const { return m_outlined; }

    /// What would be made of a template is drawn over it: lines in the file's coordinates, about
    /// its middle; null: nothing is.
    void setTraced(TemplateId of, std::shared_ptr<const std::vector<Polygon>> lines);
    /// Where the template lies now.
    Signs tracedSigns() const;

    /// Shows a model that an edit would make in place of the one that is there, as long as somebody
    /// asks what it would do; null: the model again. Nothing else knows of it.
    void setTried(std::shared_ptr<const Trials::Outcome> tried);
    AnalysisPointer tried() const { return m_tried ? m_tried->analysis : nullptr; }
    /// What is found of it; null: nothing is tried.
    const std::vector<Finding> *findingsTried() const
    {
        return m_tried ? &m_tried->findings : nullptr;
    }
    /// Whether the section is not there, or is not cut, as it is in what is tried.
    bool differsInTrial(const SectionRef &ref) const;
    /// Of few sections it is told which they are; of many nobody could tell.
    bool tellsDifferences() const { return !m_differing.empty() || !m_wasThere.empty(); }
    /// What is seen: that, or the session's.
    const Model &shownModel() const;

    /// How much of its movement the model is shown in, 0 … 1 of Movement::mostTimes(); it is
    /// neither edited nor picked there.
    void setMovement(double share);
    double movement() const { return m_movement; }

    /// Holds a tool; the one that is held already is laid down.
    void pickUp(std::unique_ptr<Tool> tool);
    void layDownTool();

    /// Whoever only looks edits nothing in the view (Interaction). What was hidden, isolated, cut
    /// open or marked in it is so no more.
    void setLooksOnly(bool looksOnly);

    /// Commits an edit of control points, or says in the status line why it was refused.
    void editPoints(PointEdit edit);
    /// The control point under the cursor goes, if there is one.
    void eraseHoveredPoint();
    /// The same of whole sections.
    void editSections(SectionEdit edit);
    /// Commits an edit of a joint, or says in the status line why it cannot be had.
    void editJoint(JointEdit edit);
    /// An arrow key (Interaction::nudge). False when nothing is selected.
    bool nudge(const Vec2 &arrow, double distance);

    /// Commits an edit; a failed one is announced by editFailed and changes nothing.
    void commit(const Step &step, Result<Document> document);
    void commit(const QString &text, Result<Document> document);

Q_SIGNALS:
    void selectionChanged();
    void pointsChanged(); // the selected control points
    void hintChanged();
    /// Camera, hover marks, gesture: what is seen but not in the model.
    void viewChanged();
    /// What is seen is another model.
    void triedChanged();
    void movementChanged();
    /// What is hidden, isolated, seen through or cut open, the projection, or the tool in the hand.
    void viewStateChanged();
    void editFailed(const fff::Error &error);
    /// The mark of this problem was clicked, or is under the cursor (0: none is).
    void problemChosen(int number, int place);
    /// The handle of this parameter was clicked.
    void parameterChosen(fff::OperationId operation, const QString &key);
    /// Or another place of it.
    void problemHovered(int number);
    /// Its line is to be ringed, and its card opened; null: nothing is asked any more.
    void weakPlaceAsked(const fff::WeakPlace *place, bool opensCard);

private:
    void announceChanges();
    void followSettings();
    void showMarks();
    void compareTried();

    Session m_session;
    SessionHost m_host;
    std::unique_ptr<Interaction> m_interaction;
    SheetNesting *m_nesting = nullptr;
    std::vector<SectionRef> m_selection; // as last announced
    std::optional<JointRef> m_joint;
    OperationId m_operation;
    LoadId m_load;
    std::vector<PointAddress> m_points;
    Hint m_hint;
    ViewState m_view;
    std::vector<SectionRef> m_outlined;
    std::vector<SectionPointer> m_ghosts;
    TemplateId m_tracedOf;
    std::shared_ptr<const std::vector<Polygon>> m_traced;
    std::shared_ptr<const Trials::Outcome> m_tried;
    std::set<SectionRef> m_differing;       // in that
    std::vector<SectionPointer> m_wasThere; // what is no more in that, or otherwise
    std::vector<ProblemMark> m_marks;
    ProblemLook m_look;
    const ProblemLook m_noLook;
    bool m_areMarksAside = false;
    int m_litProblem = 0;
    std::pair<int, int> m_hoveredProblem{0, 0}; // and which of its places
    Projection m_projection = Projection::Orthographic;
    bool m_couldGoBack = false;
    std::string m_toolCommand;               // of the tool in the hand
    Tool::Asked m_asked;                     // by it
    std::vector<std::string_view> m_offered; // commands that go with it
    bool m_couldUndoInTool = false, m_couldRedoInTool = false;
    double m_movement = 0.0;
    bool m_hadOffer = false; // its key has to know
    EventClock m_clock;
    CommandRegistry m_commands;
    std::string m_viewToShow; // asked for before there was a size
};

} // namespace fff::ui
