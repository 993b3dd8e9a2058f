#!/usr/bin/env bash
# Builds the example for Arduino as the Arduino IDE does for an Uno, runs it in an emulator, and fails unless its display shows
# the picture that the crate draws. Leaves the picture in target/uno/ball.ppm. Installs what it needs.
set -euo pipefail
cd "$(dirname "$0")/../.."
. .ci/toolchain

install_packages gcc-avr avr-libc arduino-core-avr libsimavr-dev libelf-dev gcc

core=/usr/share/arduino/hardware/arduino/avr
out=target/uno
rm -rf $out && mkdir -p $out
flags=(-mmcu=atmega328p -Os -ffunction-sections -fdata-sections -flto -DF_CPU=16000000L -DARDUINO=10819 -DARDUINO_AVR_UNO
    -DARDUINO_ARCH_AVR -I$core/cores/arduino -I$core/variants/standard -I$core/libraries/SPI/src)
# Debian's compiler does not define DECIMAL_DIG in C++
cxx=(avr-g++ -std=gnu++11 -fno-exceptions -fno-threadsafe-statics -DDECIMAL_DIG=__DECIMAL_DIG__ "${flags[@]}")
for file in $core/cores/arduino/*.c; do
    avr-gcc -std=gnu11 -w "${flags[@]}" -c "$file" -o "$out/$(basename "$file").o"
done
for file in $core/cores/arduino/*.cpp $core/libraries/SPI/src/*.cpp; do
    "${cxx[@]}" -w -c "$file" -o "$out/$(basename "$file").o"
done
"${cxx[@]}" -Wall -Wextra -Ilanguages/arduino/src -include Arduino.h -x c++ -c languages/arduino/examples/Ball/Ball.ino \
    -o $out/Ball.ino.o
avr-gcc -mmcu=atmega328p -Os -flto -fuse-linker-plugin -Wl,--gc-sections $out/*.o -o $out/ball.elf -lm
avr-size $out/ball.elf

gcc -std=gnu99 -O2 -Wall -Wextra languages/chips/uno.c -I/usr/include/simavr -o $out/emulator -lsimavr -lelf
shown=$($out/emulator $out/ball.elf $out/ball.ppm | grep '^digest')
echo "$shown"
expected=$(cd tests/firmware && cargo run --quiet --release --bin frame --features ball | awk '$1 == "fixed" { print $2 }')
[[ $shown == "digest $expected,"* ]] || {
    echo "the Uno's display does not show the crate's picture, whose digest is $expected" >&2
    exit 1
}
