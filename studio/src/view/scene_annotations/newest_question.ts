/// Questions of which only the newest counts: at most one is under way, and what came meanwhile is
/// asked after its answer. A question about another version does not wait.

export class NewestQuestion<Question extends { v: number }> {
    private number = 0;
    private underWay: Question | null = null;
    private next: Question | null = null;
    private last = ''; // that was sent

    /// `send` returns whether it could.
    constructor(private readonly send: (number: number, question: Question) => boolean) {}

    /// How many were sent.
    get count(): number {
        return this.number;
    }

    get isWaiting(): boolean {
        return this.underWay !== null;
    }

    /// Null: nothing is wanted any more.
    ask(question: Question | null): void {
        this.next = null;
        if (question === null) {
            this.forget();
        } else if (JSON.stringify(question) === this.last) {
            return;
        } else if (this.underWay?.v === question.v) {
            this.next = question;
        } else {
            this.sendNow(question);
        }
    }

    /// The answer to a question, or that it failed. False: that question is not the newest.
    answered(number: number): boolean {
        if (number !== this.number || !this.underWay) {
            return false;
        }
        this.underWay = null;
        if (this.next) {
            this.sendNow(this.next);
        }
        return true;
    }

    /// The newest question failed.
    failed(): void {
        this.answered(this.number);
    }

    /// There will be no answer: the same question may be asked again.
    forget(): void {
        this.underWay = null;
        this.next = null;
        this.last = '';
    }

    private sendNow(question: Question): void {
        this.next = null;
        if (this.send(this.number + 1, question)) {
            this.number += 1;
            this.underWay = question;
            this.last = JSON.stringify(question);
        }
    }
}
