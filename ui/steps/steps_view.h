// The view of the assembly: shows in place of the model how it is put together, step by step, until
// it is left by Esc, its bar, or any change of the model.
#pragma once

#include <QObject> // first: moc stumbles over some standard headers

#include "core/interaction/camera.h"
#include "core/session/assembly_steps.h"

#include <memory>
#include <optional>

namespace fff {
class CheckList;
class StepsPlayer;
class Tool;
} // namespace fff

namespace fff::ui {

struct Scene;
class StepsBar;
class StepsScene;
class Viewport;
class Workbench;

class StepsView : public QObject
{
    Q_OBJECT
public:
    /// viewport  null where nothing can be drawn: then there are no steps to see
    StepsView(Workbench &bench, const CheckList &list, Viewport *viewport, QObject *parent);
    ~StepsView() override;

    /// Shows them, or the model again. What is in the way is said. Where the plan is still being
    /// worked out they are waited for: shown as soon as it is there, unless by then they are
    /// toggled again, Esc is pressed, or a person has gone on with something else.
    void toggle();
    bool isOpen() const { return m_scene != nullptr; }
    /// Asked for, but not worked out yet.
    bool isWaiting() const { return m_isWaiting; }
    /// All that is there now, over the bar.
    void fit();
    /// Those that are shown; null: none are.
    AssemblyStepsPointer steps() const;
    /// In steps, as Playback counts time.
    double time() const;
    /// In the colours of the theme.
    void refresh();

Q_SIGNALS:
    /// For the status bar, with marks.
    void said(const QString &sentence);
    void waitingChanged(bool isWaiting);
    void exportWanted();

protected:
    bool eventFilter(QObject *object, QEvent *event) override;

private:
    bool isPlanned() const;
    std::optional<Error> whyNotPlanned() const;
    /// Or says why there are none. isElsewhere: a person is; then they are only offered.
    void openPlanned(bool isElsewhere = false);
    void setWaiting(bool waits);
    void giveUp(const QString &why);
    /// While they are waited for: nothing that is being done is disturbed.
    void followWork();
    void open(AssemblyStepsPointer steps);
    void close();
    /// Moves the player on and shows where it is now.
    void follow();
    void show();
    Camera fitted(const Scene &scene, const Camera &from) const;
    bool isInSight(const Scene &scene, const Camera &camera) const;
    void bringIntoSight();
    bool act(int key);
    double now();

    Workbench &m_bench;
    const CheckList &m_list;
    Viewport *m_viewport;
    StepsBar *m_bar = nullptr;
    bool m_isWaiting = false;         // for a plan
    const Tool *m_heldTool = nullptr; // since then
    std::shared_ptr<StepsPlayer> m_player;
    double m_lastFrame = 0.0, m_leftOut = 0.0; // ms
    std::unique_ptr<StepsScene> m_scene;       // while they are shown
    struct Shown
    {
        double time = -1.0, drawnApart = 0.0;
        Camera camera;
        Vec2 viewport = Vec2::Zero();
        bool isPlaying = false;
    };
    std::optional<Shown> m_shown;
    struct Brought
    {
        Camera from, to;
    };
    std::optional<Brought> m_brought; // into sight: the view was `from` as somebody chose it
};

} // namespace fff::ui
