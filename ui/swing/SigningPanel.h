#pragma once
/// Who answers for a swing: complete it, sign it, open it again or amend it, and everything that was ever done to it.

#include <QFrame>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;
class QToolButton;

#include <functional>

#include "db/openpgp/Gpg.h"
#include "ui/kit/EditContext.h"
#include "ui/kit/Worker.h"

namespace lubberline::ui {

class KeyChecks;
class SwingEditor;

class SigningPanel : public QFrame {
    Q_OBJECT

public:
    /// Of the swing that the editor holds: the panel has no record of its own.
    SigningPanel(EditContext& context, const SwingEditor& editor, KeyChecks& keys, QWidget* parent = nullptr);
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
    void fillSignatures();
    void showTrail();
    void showDifferences();
    void showAudit();
    void changeState();
    void sign();
    void amend();
    [[nodiscard]] static QString standsFor(const Signature& one, const SignatureState& state);
    bool done(const Result<void>& result);
    Result<void> asSeen(const std::function<Result<void>()>& act);

    // SigningPanelKeys.cpp: what gpg is asked for, on workers
    void listKeys();
    void showKeys(const Result<std::vector<db::OpenPgpKey>>& keys);
    void signWithKey(Signature signature);
    void finishSigning(const Result<Signature>& made);

    [[nodiscard]] const SwingRecord& record() const;

protected:
    void showEvent(QShowEvent* event) override;

private:
    EditContext& m_context;
    const SwingEditor& m_editor;
    KeyChecks& m_keys;
    QLabel* m_strip;
    QLabel* m_statement;
    QTableWidget* m_signatures;
    QLabel* m_trail; ///< what speaks against the record as it stands
    QWidget* m_signRow;
    QComboBox* m_role;
    QComboBox* m_key; ///< of the user's key ring; the first: none, a name that nobody verifies
    QLineEdit* m_name;
    QLineEdit* m_licence;
    QPushButton* m_sign;
    QPushButton* m_cancel; ///< waiting for the key
    QLineEdit* m_reason;   ///< of opening again, and of amending
    QPushButton* m_change;
    QPushButton* m_amend;
    QTableWidget* m_differences;
    QToolButton* m_showAudit;
    QTableWidget* m_audit;
    bool m_listed = false;
    SwingId m_signing; ///< what is being signed by a key
    Worker<std::vector<db::OpenPgpKey>> m_listing;
    Worker<Signature> m_byKey;
};

} // namespace lubberline::ui
