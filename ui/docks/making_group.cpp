#include "ui/docks/making_group.h"

#include "core/analysis/facetted.h"
#include "core/analysis/suggesting/suggestion.h"
#include "ui/properties/kept_number.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

#include <initializer_list>

namespace fff::ui {

namespace {

constexpr int kButtonGap = 6; // px
constexpr int kSuggestedSlid = 40, kFacesSlid = 200;

void addButtons(PropertyGroup *group, std::initializer_list<QWidget *> buttons)
{
    auto *all = new QWidget(group);
    auto *column = new QVBoxLayout(all);
    column->setContentsMargins(0, kButtonGap, 0, 0);
    column->setSpacing(kButtonGap);
    for (QWidget *button : buttons)
        column->addWidget(button);
    group->add(all);
}

} // namespace

MakingGroup::MakingGroup(QWidget *parent) : QWidget(parent)
{
    auto *sections = new PropertyGroup(tr("Suggest sections"), this);
    SliderField *count = addKeptNumber(*sections, tr("How many"), "suggestCount",
                                       {1, kSuggestedSlid, kMostSuggested}, &m_count)
                             .field;
    QPushButton *suggest =
        button(tr("Suggest"), "suggestSections",
               tr("Finds sections that show its form, hold each other and stand"));
    m_more = button(tr("One more"), "suggestOneMore", tr("A section that fits among those there"));
    m_another = button(tr("Another"), "suggestAnother", tr("Other sections instead of the last"));
    connect(suggest, &QPushButton::clicked, this, [this, count] {
        count->settle();
        Q_EMIT suggestionWanted(m_count);
    });
    connect(m_more, &QPushButton::clicked, this, &MakingGroup::oneMoreWanted);
    connect(m_another, &QPushButton::clicked, this, &MakingGroup::anotherWanted);
    auto *others = new QWidget(sections);
    auto *row = new QHBoxLayout(others);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kButtonGap);
    row->addWidget(m_more);
    row->addWidget(m_another);
    addButtons(sections, {suggest, others});

    auto *sheets = new PropertyGroup(tr("Facets"), this);
    SliderField *faces = addKeptNumber(*sheets, tr("Faces"), "facetFaces",
                                       {int(kFewestFaces), kFacesSlid, int(kMostFacets)}, &m_faces)
                             .field;
    QPushButton *facets =
        button(tr("Make facets"), "makeFacets",
               tr("Builds it of flat sheets with fingers along their edges. The mesh is simplified "
                  "to so many faces first; those that lie flat together are one sheet."));
    connect(facets, &QPushButton::clicked, this, [this, faces] {
        faces->settle();
        Q_EMIT facetsWanted(m_faces);
    });

    QPushButton *net =
        button(tr("Unfold"), "makeNet",
               tr("Lays it flat, to be cut of card in one piece or a few and folded along scored "
                  "lines. Edges to join have the same number."));
    connect(net, &QPushButton::clicked, this, [this, faces] {
        faces->settle();
        Q_EMIT netWanted(m_faces);
    });
    addButtons(sheets, {facets, net});
    sheets->fold();

    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(sections);
    column->addWidget(sheets);
    refresh(false, false);
}

QPushButton *MakingGroup::button(const QString &text, const char *name, const QString &tip)
{
    auto *made = new QPushButton(text, this);
    made->setObjectName(QLatin1String(name));
    made->setToolTip(tip);
    made->setAutoDefault(false);
    return made;
}

void MakingGroup::refresh(bool hasSections, bool hasLast)
{
    m_more->setEnabled(hasSections);
    m_another->setEnabled(hasLast);
}

} // namespace fff::ui
