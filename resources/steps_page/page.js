// The page: slider, buttons and keys. Without WebGL it stays as it came, with its pictures.
'use strict';

const STEP_MS = 1500, JUMP_MS = 350, REST_MS = 120;
const MOST_PIXELS = 2; // of the screen for one of the page: more is not seen, and makes phones hot

class Page {
    constructor(model, marks, data) {
        Object.assign(this, {model, marks, data, count: data.steps.length, time: data.steps.length});
        const element = id => document.getElementById(id);
        this.stage = element('stage');
        this.slider = element('time');
        this.buttons = {previous: element('previous'), play: element('play'), next: element('next')};
        this.words = {title: element('step-title'), text: element('step-text')};
        this.rows = [...document.querySelectorAll('#parts tbody tr')];
        Object.assign(this.slider, {min: 0, max: this.count, step: 0.01});
        this.slider.addEventListener('input', () => this.goTo(Number(this.slider.value)));
        this.buttons.previous.addEventListener('click', () => this.jump(-1));
        this.buttons.next.addEventListener('click', () => this.jump(1));
        this.buttons.play.addEventListener('click', () => this.isPlaying ? this.stop() : this.playOn());
        document.addEventListener('keydown', event => this.onKey(event));
        this.scheme = matchMedia('(prefers-color-scheme: dark)');
        this.scheme.onchange = () => {
            model.makeLooks();
            this.show(this.time);
        };
        // Phones take the graphics away from pages that are not looked at, and give them back.
        model.renderer.domElement.addEventListener('webglcontextrestored', () => this.redraw());
        new Fingers(this.stage, model, () => this.redraw());
        new ResizeObserver(() => this.resize()).observe(this.stage);
        this.resize();
        this.show(this.time);
    }

    onKey(event) {
        const acts = {
            ArrowLeft: () => this.jump(-1), ArrowDown: () => this.jump(-1),
            ArrowRight: () => this.jump(1), ArrowUp: () => this.jump(1),
            Home: () => this.goTo(0), End: () => this.goTo(this.count),
            ' ': () => this.isPlaying ? this.stop() : this.playOn(),
        };
        // A button that has the focus is pressed by the space bar.
        if (event.key === ' ' && document.activeElement instanceof HTMLButtonElement)
            return;
        // Up and down scroll the page, unless the slider has the focus.
        const isForPage = event.key === 'ArrowUp' || event.key === 'ArrowDown';
        if (event.altKey || event.ctrlKey || event.metaKey || !acts[event.key] ||
            (isForPage && document.activeElement !== this.slider))
            return;
        event.preventDefault();
        acts[event.key]();
    }

    /// To the end of the next step, or back to the beginning of this one.
    jump(by) {
        const from = this.isPlaying || this.target === undefined ? this.time : this.target;
        const to = by > 0 ? Math.floor(from + 1e-6) + 1 : Math.ceil(from - 1e-6) - 1;
        const target = Math.min(Math.max(to, 0), this.count);
        this.stop();
        this.animate(target, by > 0 ? STEP_MS * Math.min(target - this.time, 1) : JUMP_MS);
    }

    goTo(time) {
        this.stop();
        this.show(time);
    }

    playOn() {
        this.stop();
        if (this.time >= this.count)
            this.show(0);
        this.setPlaying(true);
        this.animate(this.count, STEP_MS * (this.count - this.time));
    }

    stop() {
        cancelAnimationFrame(this.frame);
        this.target = undefined;
        this.setPlaying(false);
    }

    setPlaying(isPlaying) {
        const {play} = this.buttons, {texts} = this.data;
        this.isPlaying = isPlaying;
        play.classList.toggle('is-playing', isPlaying);
        play.title = isPlaying ? texts.pause : texts.play;
        play.setAttribute('aria-label', play.title);
    }

    animate(target, duration) {
        const from = this.time;
        let begun;
        this.target = target;
        const go = now => {
            begun = begun === undefined ? now : begun;
            const share = duration > 0 ? Math.min((now - begun) / duration, 1) : 1;
            this.show(share < 1 ? from + share * (target - from) : target);
            if (share < 1)
                this.frame = requestAnimationFrame(go);
            else
                this.stop();
        };
        this.frame = requestAnimationFrame(go);
    }

    show(time) {
        this.time = time;
        this.model.show(time);
        const {playback} = this.model, {texts, steps} = this.data;
        const isFinished = playback.isFinished(time), step = steps[playback.stepAt(time)];
        this.say(this.words.title, isFinished ? texts.finished : step.title);
        this.say(this.words.text, isFinished ? texts.facts : step.text);
        this.slider.value = time;
        this.slider.setAttribute('aria-valuetext', isFinished ? texts.finished : `${step.title}: ${step.text}`);
        this.buttons.previous.disabled = time <= 0;
        this.buttons.next.disabled = isFinished;
        this.model.parts.forEach((part, i) => this.rows[i].classList.toggle('is-moving', part.isMoving));
        this.showRow(this.rows[this.model.parts.findIndex(part => part.isMoving)]);
        this.redraw();
    }

    /// In the list beside a wide stage; on a phone it is below, and the page stays where it is.
    showRow(row) {
        const list = document.getElementById('parts');
        if (!row || getComputedStyle(list).overflowY !== 'auto')
            return;
        const seen = list.getBoundingClientRect(), own = row.getBoundingClientRect();
        if (own.top < seen.top || own.bottom > seen.bottom)
            list.scrollTop += own.top - seen.top - seen.height / 3;
    }

    /// Only what is new, since it is read out.
    say(element, text) {
        if (element.textContent !== text)
            element.textContent = text;
    }

    resize() {
        const {clientWidth: width, clientHeight: height} = this.stage;
        if (width === 0 || height === 0)
            return;
        const ratio = Math.min(devicePixelRatio || 1, MOST_PIXELS);
        this.model.resize(width, height, ratio);
        this.marks.resize(width, height, devicePixelRatio || 1);
        this.draw(true);
    }

    redraw() {
        clearTimeout(this.rest);
        this.rest = setTimeout(() => this.draw(true), REST_MS);
        if (!this.isAsked)
            requestAnimationFrame(() => this.draw(false));
        this.isAsked = true;
    }

    draw(isLast) {
        this.isAsked = false;
        this.model.draw();
        this.marks.draw(performance.now(), isLast);
    }
}

function begin() {
    const data = JSON.parse(document.getElementById('data').textContent);
    const canvas = document.getElementById('model');
    const options = {alpha: true, antialias: true};
    const context = canvas.getContext('webgl2', options) || canvas.getContext('webgl', options);
    if (!context)
        return;
    const show = hasModel => {
        document.getElementById('viewer').hidden = !hasModel;
        document.getElementById('pictures').hidden = hasModel;
        document.documentElement.classList.toggle('has-model', hasModel);
    };
    show(true);
    try {
        const model = new Model(canvas, context, data);
        new Page(model, new Marks(document.getElementById('marks'), model), data);
    } catch (error) {
        show(false); // an old browser has pictures rather than half a page
    }
}

begin();
