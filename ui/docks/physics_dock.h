// What hangs on the model, and how it bears it: the state of what is worked out, loads, the weakest
// places, how strict the verdict is.
#pragma once

#include <QDockWidget> // first: moc stumbles over some standard headers

#include "core/analysis/weak_place.h"

#include <vector>

class QCheckBox;
class QLabel;
class QToolButton;

namespace fff {
class CheckList;
struct Holding;
} // namespace fff

namespace fff::ui {

class MovementRows;
class PlaceButton;
class PropertyGroup;
class PropertyRow;
class VaryingRows;
class Workbench;

class PhysicsDock : public QDockWidget
{
    Q_OBJECT
public:
    PhysicsDock(Workbench &bench, QWidget *parent = nullptr);

    /// In the colours of the theme.
    void refreshColours() { refresh(); }

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    /// Of a row of the weakest places: it rings its line while it is hovered or has the keys, and
    /// Enter opens the card of that.
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    /// A row of the weakest places.
    struct Place
    {
        WeakPlace place;
        double use = 0.0;
    };

    void makeLoads(QWidget *parent);
    QWidget *makeRules(QWidget *parent);
    void addLoadRow(std::size_t index);
    void refresh();
    void refreshBending();
    void refreshStrong();
    void refreshState();
    void refreshLoads();
    void refreshPlaces();
    std::vector<Place> weakestPlaces() const;
    void frame(WeakPlace place); // what is listed is listed anew meanwhile
    void showStressOnce();

    Workbench &m_bench;
    std::shared_ptr<const Holding> m_held; // null: nothing is known
    bool m_hasShownStress = false;
    QLabel *m_stateIcon = nullptr, *m_state = nullptr;
    QCheckBox *m_lines = nullptr, *m_bends = nullptr;
    QToolButton *m_stop = nullptr; // what is worked out with sections that bend
    MovementRows *m_movement = nullptr;
    QCheckBox *m_strong = nullptr; // where a section is strong enough
    QToolButton *m_stopStrong = nullptr;
    PropertyGroup *m_loads = nullptr, *m_placesGroup = nullptr;
    VaryingRows *m_weights = nullptr;
    std::vector<PropertyRow *> m_sums, m_rules;
    QLabel *m_empty = nullptr;
    std::vector<PlaceButton *> m_places;
    std::vector<Place> m_shown; // one a button
};

} // namespace fff::ui
