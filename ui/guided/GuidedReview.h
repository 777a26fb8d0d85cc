#pragma once
/// The whole swing before it is accepted: residuals, what was skipped and voided, whether it stays within limits. From here a
/// station can be read again, or a control turned again, which voids the check swing.

#include <QWidget>

#include "ui/guided/GuidedJob.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace lubberline::ui {

class GuidedReview : public QWidget {
    Q_OBJECT

public:
    explicit GuidedReview(GuidedJob& job, QWidget* parent = nullptr);
    void refresh();
    void focusField();

signals:
    void failed(const QString& message);
    void finish(); ///< the review is accepted: the records are to be made

private:
    void build();
    void fillTable();
    void addSkipped(int configuration);
    [[nodiscard]] QString verdict() const;
    void accept();
    void readAgain();
    void turnAgain();
    bool tell(job::What what);

    GuidedJob& m_job;
    QTableWidget* m_table;
    QLabel* m_verdict;
    QLabel* m_notes;
    QLineEdit* m_by;
    QPushButton* m_accept;
    QPushButton* m_again;
    QComboBox* m_control;
    QLineEdit* m_after;
    QPushButton* m_turn;
    std::vector<int> m_stations; ///< of the rows
};

} // namespace lubberline::ui
