// A joystick on the screen, for touch and mouse.

export function makeJoystick(element, onMove) {
  const knob = element.querySelector('.knob');
  let pointer = null;
  const move = (event) => {
    const box = element.getBoundingClientRect();
    const radius = box.width / 2;
    let x = (event.clientX - box.left - radius) / radius;
    let y = (event.clientY - box.top - radius) / radius;
    const length = Math.max(Math.hypot(x, y), 1);
    x /= length;
    y /= length;
    knob.style.transform = `translate(${x * radius * 0.6}px, ${y * radius * 0.6}px)`;
    onMove({ forward: Math.abs(y) < 0.12 ? 0 : -y, left: Math.abs(x) < 0.12 ? 0 : -x });
  };
  element.addEventListener('pointerdown', (event) => {
    pointer = event.pointerId;
    element.setPointerCapture(pointer);
    move(event);
  });
  element.addEventListener('pointermove', (event) => {
    if (event.pointerId === pointer) move(event);
  });
  for (const end of ['pointerup', 'pointercancel']) {
    element.addEventListener(end, () => {
      pointer = null;
      knob.style.transform = '';
      onMove({ forward: 0, left: 0 });
    });
  }
}
