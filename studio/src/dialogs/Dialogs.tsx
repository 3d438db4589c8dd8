import { Dialog } from './Dialog';
import { closeDialog, openDialogs, type OpenDialog } from './open_dialogs';

function Body({ dialog }: { dialog: OpenDialog }) {
    return <>{dialog.body?.()}</>;
}

function One({ dialog }: { dialog: OpenDialog & { id: number } }) {
    return (
        <Dialog
            title={dialog.title}
            actions={dialog.actions?.() ?? []}
            size={dialog.size ?? 'small'}
            onClose={() => closeDialog(dialog.id)}
            onDismiss={() => { closeDialog(dialog.id); dialog.onDismiss?.(); }}
        >
            <Body dialog={dialog} />
        </Dialog>
    );
}

/// All dialogs that were opened by `openDialog`.
export function Dialogs() {
    return <>{openDialogs.value.map((dialog) => <One key={dialog.id} dialog={dialog} />)}</>;
}
