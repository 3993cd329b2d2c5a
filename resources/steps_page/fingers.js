// What fingers and the mouse do on the stage: one turns, two zoom and shift, a wheel zooms, two taps
// show all of it again.
'use strict';

const TAP_MS = 320, TAP_PIXELS = 24;

class Fingers {
    constructor(stage, model, changed) {
        Object.assign(this, {stage, model, changed, held: new Map(), tap: null});
        stage.addEventListener('pointerdown', event => this.press(event));
        stage.addEventListener('pointermove', event => this.move(event));
        for (const name of ['pointerup', 'pointercancel'])
            stage.addEventListener(name, event => this.release(event));
        stage.addEventListener('wheel', event => {
            event.preventDefault();
            const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 30 : 1;
            this.act(() => model.nearer(Math.exp(-0.0015 * lines * event.deltaY)));
        }, {passive: false});
    }

    act(change) {
        change();
        this.stage.classList.add('was-turned');
        this.changed();
    }

    press(event) {
        event.preventDefault();
        this.stage.setPointerCapture(event.pointerId);
        this.held.set(event.pointerId, {x: event.clientX, y: event.clientY});
        this.stage.classList.add('is-held');
        const before = this.tap;
        this.tap = this.held.size > 1 ? null : {x: event.clientX, y: event.clientY, at: event.timeStamp};
        if (before && this.tap && event.timeStamp - before.at < TAP_MS &&
            Math.hypot(event.clientX - before.x, event.clientY - before.y) < TAP_PIXELS) {
            this.tap = null;
            this.act(() => this.model.home());
        }
    }

    move(event) {
        const finger = this.held.get(event.pointerId);
        if (!finger)
            return;
        const now = {x: event.clientX, y: event.clientY};
        if (this.held.size === 1) {
            this.act(() => this.model.turn(now.x - finger.x, now.y - finger.y));
        } else {
            const other = [...this.held].find(([id]) => id !== event.pointerId)[1];
            const apart = p => Math.max(Math.hypot(p.x - other.x, p.y - other.y), 1);
            this.act(() => {
                this.model.nearer(apart(now) / apart(finger));
                this.model.shift((now.x - finger.x) / 2, (now.y - finger.y) / 2);
            });
        }
        if (this.tap && Math.hypot(now.x - this.tap.x, now.y - this.tap.y) > TAP_PIXELS)
            this.tap = null;
        this.held.set(event.pointerId, now);
    }

    release(event) {
        this.held.delete(event.pointerId);
        this.stage.classList.toggle('is-held', this.held.size > 0);
    }
}
