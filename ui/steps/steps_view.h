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
} // namespace fff

namespace fff::ui {

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
    /// worked out they are shown as soon as it is there.
    void toggle();
    bool isOpen() const { return m_scene != nullptr; }
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
    void exportWanted();

protected:
    bool eventFilter(QObject *object, QEvent *event) override;

private:
    void openWhenPlanned();
    void open(AssemblyStepsPointer steps);
    void close();
    /// Moves the player on and shows where it is now.
    void follow();
    void show();
    bool act(int key);

    Workbench &m_bench;
    const CheckList &m_list;
    Viewport *m_viewport;
    StepsBar *m_bar = nullptr;
    bool m_isWanted = false; // as soon as there is a plan
    std::shared_ptr<StepsPlayer> m_player;
    std::unique_ptr<StepsScene> m_scene; // while they are shown
    struct Shown
    {
        double time = -1.0, drawnApart = 0.0;
        Camera camera;
        Vec2 viewport = Vec2::Zero();
        bool isPlaying = false;
    };
    std::optional<Shown> m_shown;
};

} // namespace fff::ui
