#include "ui/docks/properties_dock.h"

#include "core/session/check_list.h"
#include "ui/bench/check_words.h"
#include "ui/bench/workbench.h"
#include "ui/docks/dock_title.h"
#include "ui/docks/drawing_page.h"
#include "ui/docks/joint_page.h"
#include "ui/docks/load_page.h"
#include "ui/docks/model_page.h"
#include "ui/docks/operation_page.h"
#include "ui/docks/problem_box.h"
#include "ui/docks/properties_header.h"
#include "ui/docks/section_page.h"
#include "ui/settings/settings.h"

#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>

namespace fff::ui {

PropertiesDock::PropertiesDock(Workbench &bench, const CheckList &list, QWidget *parent)
    : QDockWidget(tr("Properties"), parent), m_bench(bench), m_list(list)
{
    dressDock(this, "propertiesDock");
    auto *area = new QScrollArea(this);
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setFocusPolicy(Qt::NoFocus); // its fields have it
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto *content = new QWidget(area);
    m_header = new PropertiesHeader(bench, content);
    m_problem = new ProblemBox("sectionProblem", content);
    m_modelPage = new ModelPage(bench, content);
    m_sectionPage = new SectionPage(bench, content);
    m_jointPage = new JointPage(bench, content);
    m_operationPage = new OperationPage(bench, content);
    m_loadPage = new LoadPage(bench, content);
    auto *column = new QVBoxLayout(content);
    column->setContentsMargins(12, 12, 12, 12);
    column->setSpacing(0);
    column->addWidget(m_header);
    column->addWidget(m_problem);
    column->addWidget(m_modelPage);
    column->addWidget(m_sectionPage);
    column->addWidget(m_jointPage);
    column->addWidget(m_operationPage);
    column->addWidget(m_loadPage);
    m_drawingPage = new DrawingPage(bench, content);
    column->addWidget(m_drawingPage);
    column->addStretch(1);
    area->setWidget(content);
    setWidget(area);
    // What is scrolled out of sight is told so by no event.
    connect(area->verticalScrollBar(), &QScrollBar::valueChanged, m_sectionPage,
            &SectionPage::tellListed);

    connect(m_modelPage, &ModelPage::stockWanted, this, &PropertiesDock::stockWanted);
    connect(m_sectionPage, &SectionPage::stockWanted, this, &PropertiesDock::stockWanted);
    // What had the focus is hidden then: it goes on to where one is.
    connect(m_sectionPage, &SectionPage::jointWanted, this, [this](const JointRef &joint) {
        m_bench.setOutlined({});
        m_bench.selectJoint(joint);
        m_jointPage->setFocus();
    });
    connect(m_jointPage, &JointPage::sectionWanted, this,
            [this](const SectionRef &section, const SectionRef &other) {
                m_bench.setOutlined({});
                m_bench.select({section});
                m_sectionPage->focusJoint(other);
            });
    connect(&bench, &Workbench::parameterChosen, this, [this](OperationId, const QString &key) {
        show();
        raise();
        refresh();
        m_operationPage->focusParameter(key);
    });
    connect(&bench, &Workbench::selectionChanged, this, &PropertiesDock::refresh);
    connect(&bench, &Workbench::viewStateChanged, this, [this] { // another tool
        if (!m_operationPage->isHidden())
            refresh();
    });
    connect(&bench, &Workbench::pointsChanged, this, &PropertiesDock::refresh);
    connect(&bench.session(), &Session::modelChanged, this, &PropertiesDock::follow);
    connect(&bench.session(), &Session::analysisChanged, this, &PropertiesDock::follow);
    connect(&list, &CheckList::changed, this, &PropertiesDock::tellProblem);
    connect(&settings(), &Settings::unitChanged, this, &PropertiesDock::refresh);
    connect(&bench, &Workbench::viewChanged, this, [this] {
        if (m_drawingPage->isWanted() || !m_drawingPage->isHidden())
            follow();
    });
    m_soon.setSingleShot(true);
    m_soon.setInterval(0);
    connect(&m_soon, &QTimer::timeout, this, &PropertiesDock::refresh);
    connect(this, &QDockWidget::visibilityChanged, this, &PropertiesDock::refresh);
}

/// While something is drawn, each move changes overlay, model and analysis: all at once is enough.
void PropertiesDock::follow()
{
    if (m_drawingPage->isWanted() && !m_drawingPage->isHidden())
        m_soon.start();
    else
        refresh();
}

void PropertiesDock::refresh()
{
    m_soon.stop();
    if (!isVisible())
        return; // once it is seen again
    const bool isDrawing = m_drawingPage->isWanted();
    m_drawingPage->setVisible(isDrawing);
    m_header->setVisible(!isDrawing);
    const bool hasSection = !selectedSections(m_bench).empty();
    const bool hasJoint = m_bench.interaction().selectedJoint().has_value();
    const bool hasOperation = m_bench.interaction().selectedOperation().isValid();
    m_jointPage->follow();
    m_operationPage->follow();
    m_loadPage->follow();
    const bool hasLoad = m_bench.interaction().selectedLoad().isValid();
    m_modelPage->setVisible(!hasSection && !hasJoint && !hasOperation && !hasLoad && !isDrawing);
    m_loadPage->setVisible(hasLoad && !isDrawing);
    m_operationPage->setVisible(hasOperation && !isDrawing);
    m_jointPage->setVisible(hasJoint && !isDrawing);
    m_sectionPage->setVisible(hasSection && !isDrawing);
    tellProblem();
    if (isDrawing) {
        m_drawingPage->refresh();
        return;
    }
    m_header->refresh();
    if (hasJoint)
        m_jointPage->refresh();
    else if (hasOperation)
        m_operationPage->refresh();
    else if (hasSection)
        m_sectionPage->refresh();
    else if (hasLoad)
        m_loadPage->refresh();
    else
        m_modelPage->refresh();
}

void PropertiesDock::setChosen(const std::optional<Finding> &finding)
{
    m_chosen = finding;
    tellProblem();
}

/// What is wrong with the section that is selected: what is chosen in Checks, or the worst.
void PropertiesDock::tellProblem()
{
    const std::vector<int> sections = selectedSections(m_bench);
    const Finding *worst = nullptr, *chosen = nullptr;
    int others = -1;
    if (sections.size() == 1 && !m_sectionPage->isHidden()) {
        const SectionRef section =
            m_bench.session().model().ref(static_cast<std::size_t>(sections.front()));
        for (const Finding &finding : m_list.all()) {
            const std::vector<SectionRef> whom = concerned(finding);
            if (finding.severity < Severity::Warning ||
                std::find(whom.begin(), whom.end(), section) == whom.end())
                continue;
            ++others;
            const bool isWorse = !worst || finding.severity > worst->severity;
            if (m_chosen && isSameVerdict(finding, *m_chosen))
                chosen = &finding;
            if (isWorse)
                worst = &finding;
        }
    }
    if (chosen)
        worst = chosen;
    if (!worst) {
        m_problem->hide();
        return;
    }
    const CheckWords words = checkWords(*worst, m_list.model());
    QString html = QStringLiteral("<b>%1.</b> %2")
                       .arg(words.title.toHtmlEscaped(), words.text.toHtmlEscaped());
    if (others > 0)
        html += QStringLiteral("<br>") + tr("%n more in Checks.", nullptr, others);
    m_problem->tell(worst->severity, html);
}

} // namespace fff::ui
