#pragma once
/// Who answers for a swing: complete it, sign it, open it again or amend it, and everything that was ever done to it.

#include <QFrame>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;
class QToolButton;

#include "ui/kit/EditContext.h"

namespace lubberline::ui {

class SwingEditor;

class SigningPanel : public QFrame {
    Q_OBJECT

public:
    /// Of the swing that the editor holds: the panel has no record of its own.
    SigningPanel(EditContext& context, const SwingEditor& editor, QWidget* parent = nullptr);
    /// @param meaning what the swing says, in words: what is being signed.
    void show(const QString& meaning);
    void focusField();
    void askReason(); ///< why a complete swing is opened again

signals:
    void failed(const QString& message);
    void openSwing(lubberline::SwingId id); ///< an amendment was begun

private:
    void build();
    void showState();
    void showSignatures();
    void showDifferences();
    void showAudit();
    void changeState();
    void sign();
    void amend();
    bool done(const Result<void>& result);

    [[nodiscard]] const SwingRecord& record() const;

    EditContext& m_context;
    const SwingEditor& m_editor;
    QLabel* m_strip;
    QLabel* m_statement;
    QTableWidget* m_signatures;
    QWidget* m_signRow;
    QComboBox* m_role;
    QLineEdit* m_name;
    QLineEdit* m_licence;
    QPushButton* m_sign;
    QLineEdit* m_reason; ///< of opening again, and of amending
    QPushButton* m_change;
    QPushButton* m_amend;
    QTableWidget* m_differences;
    QToolButton* m_showAudit;
    QTableWidget* m_audit;
};

} // namespace lubberline::ui
