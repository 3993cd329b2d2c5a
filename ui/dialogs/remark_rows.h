// Remarks as rows: glyph, sentence, and Show where there is something to show. At most a few are in
// sight, the others are scrolled to.
#pragma once

#include <QScrollArea> // first: moc stumbles over some standard headers

#include "ui/dialogs/export_remarks.h"

class QVBoxLayout;

namespace fff::ui {

class RemarkRows : public QScrollArea
{
    Q_OBJECT
public:
    /// before  that Tab comes from: rows are made anew while it is there
    explicit RemarkRows(QWidget *before, QWidget *parent = nullptr);

    /// Changes nothing where the same is said.
    void setRemarks(std::vector<ExportRemark> remarks);
    const std::vector<ExportRemark> &remarks() const { return m_remarks; }

Q_SIGNALS:
    void showWanted(int index);

protected:
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    QWidget *makeRow(const ExportRemark &remark, int index);
    void orderLinks();
    void rebuild();
    void takeHeight();

    std::vector<ExportRemark> m_remarks;
    QWidget *m_before = nullptr;
    QWidget *m_rows = nullptr;
    QVBoxLayout *m_column = nullptr;
};

} // namespace fff::ui
