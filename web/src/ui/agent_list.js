// The list of agents, who is followed and who is driven.

import { byId, make } from './dom.js';

export class AgentList {
  /** actions: {follow(name), drive(name)}; mayDrive: () -> boolean */
  constructor(actions, mayDrive) {
    this.actions = actions;
    this.mayDrive = mayDrive;
    this.items = new Map();
  }

  setTable(rows) {
    this.items.clear();
    // Who can be driven comes first.
    const sorted = [...rows].sort((a, b) => Number(b.controllable) - Number(a.controllable) || a.name.localeCompare(b.name));
    byId('agents').replaceChildren(...sorted.map((row) => {
      const state = make('small', {}, row.species);
      const item = make('li', {}, make('div', {}, row.name, state));
      const add = (text, act) => {
        const button = make('button', {}, text);
        button.setAttribute('aria-label', `${text} ${row.name}`);
        button.addEventListener('click', () => act(row.name));
        item.append(button);
      };
      add('Follow', this.actions.follow);
      if (row.controllable && this.mayDrive()) add('Drive', this.actions.drive);
      this.items.set(row.name, { state, row });
      return item;
    }));
  }

  update(entries, behaviours) {
    for (const { name, thing } of entries) {
      const item = this.items.get(name);
      if (!item || !thing) continue;
      const text = `${item.row.species} · ${behaviours[thing.behaviour] ?? ''} · ${Math.round(thing.health / 2.55)} %`;
      if (item.state.textContent !== text) item.state.textContent = text;
    }
  }
}

const kMostEvents = 40;

/** Adds a line to the list of events. */
export function showEvent({ kind, agent, other, time_s }) {
  const text = `${time_s.toFixed(1)} s  ${agent} ${kind.replaceAll('_', ' ')}${other ? ` ${other}` : ''}`;
  byId('events').prepend(make('li', {}, text));
  while (byId('events').children.length > kMostEvents) byId('events').lastChild.remove();
}
