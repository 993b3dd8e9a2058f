/* Shades scenes with the fixed-function lighting of Mesa's OpenGL: a vertex for each scene, drawn as a point. It reads
 * and writes the format of ../../docs/format.md.
 *
 * OpenGL's lighting has the eye at the origin, so positions are relative to the eye. The projection ignores the position
 * and sends each vertex to the next pixel: none is clipped, and one frame holds SIDE * SIDE scenes. */
#define _POSIX_C_SOURCE 200809L
#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>
#include <GL/glext.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 256, MOST_LIGHTS = 8 };

static float frame[SIDE * SIDE][4];
static int scenes; /* drawn in this frame */

static void fail(const char *message) {
    fprintf(stderr, "mesa: %s\n", message);
    exit(1);
}

/* Reads the next number of a scene. The names in a scene have no digits and no minus. */
static GLfloat number(const char **rest) {
    const char *start = *rest + strcspn(*rest, "-0123456789");
    char *end;
    const double value = strtod(start, &end);
    if (end == start)
        fail("a scene is too short");
    *rest = end;
    return (GLfloat)value;
}

/* Reads three numbers; the fourth is given. */
static void numbers(const char **rest, GLfloat to[4], GLfloat fourth) {
    for (int i = 0; i < 3; i++)
        to[i] = number(rest);
    to[3] = fourth;
}

static void material(GLenum property, const char **rest) {
    GLfloat color[4];
    numbers(rest, color, 1);
    glMaterialfv(GL_FRONT_AND_BACK, property, color);
}

static void light(GLenum id, const char **rest, const GLfloat eye[4]) {
    const char kind = **rest; /* directional, point, spot */
    GLfloat intensity[4], position[4], axis[4] = {0, 0, -1, 0}, attenuation[4] = {1, 0, 0, 0}, degrees = 180;
    numbers(rest, intensity, 1);
    numbers(rest, position, kind != 'd');
    if (kind != 'd') {
        for (int i = 0; i < 3; i++)
            position[i] -= eye[i];
        numbers(rest, attenuation, 0);
    }
    if (kind == 's') {
        numbers(rest, axis, 0);
        degrees = fminf(90, number(rest) * (GLfloat)(180 / 3.14159265358979323846));
    }
    glLightfv(id, GL_DIFFUSE, intensity);
    glLightfv(id, GL_SPECULAR, intensity);
    glLightfv(id, GL_POSITION, position);
    glLightf(id, GL_CONSTANT_ATTENUATION, attenuation[0]);
    glLightf(id, GL_LINEAR_ATTENUATION, attenuation[1]);
    glLightf(id, GL_QUADRATIC_ATTENUATION, attenuation[2]);
    glLightfv(id, GL_SPOT_DIRECTION, axis);
    glLightf(id, GL_SPOT_CUTOFF, degrees);
    glEnable(id);
}

static void draw(const char *rest) {
    GLfloat p[4], n[4], v[4], eye[4], ambient[4];
    const int lambert = strstr(rest, "\"lambert\"") != NULL;
    numbers(&rest, p, 1);
    numbers(&rest, n, 0);
    numbers(&rest, v, 0);
    for (int i = 0; i < 3; i++)
        eye[i] = p[i] + v[i];
    material(GL_AMBIENT, &rest);
    material(GL_DIFFUSE, &rest);
    material(GL_SPECULAR, &rest);
    if (lambert)
        glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, (GLfloat[]){0, 0, 0, 1});
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, number(&rest));
    numbers(&rest, ambient, 1);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);

    int lights = 0;
    for (; (rest = strstr(rest, "\"kind\":\"")); lights++) {
        if (lights == MOST_LIGHTS)
            fail("a scene has too many lights");
        rest += strlen("\"kind\":\"");
        light(GL_LIGHT0 + (GLenum)lights, &rest, eye);
    }
    for (int i = lights; i < MOST_LIGHTS; i++)
        glDisable(GL_LIGHT0 + (GLenum)i);

    const GLfloat x = (GLfloat)(2 * (scenes % SIDE) + 1) / SIDE - 1;
    const GLfloat y = (GLfloat)(2 * (scenes / SIDE) + 1) / SIDE - 1;
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixf((GLfloat[]){0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, x, y, 0, 1});
    glBegin(GL_POINTS);
    glNormal3fv(n);
    glVertex3f(-v[0], -v[1], -v[2]);
    glEnd();
    scenes++;
}

static void put(char before, float channel) {
    if (isnan(channel))
        printf("%cNaN", before);
    else if (isinf(channel))
        printf("%c%sInfinity", before, channel < 0 ? "-" : "");
    else
        printf("%c%.9g", before, channel);
}

static void answer(void) {
    glFinish();
    if (glGetError() != GL_NO_ERROR)
        fail("an OpenGL error");
    for (int i = 0; i < scenes; i++) {
        put('[', frame[i][0]);
        put(',', frame[i][1]);
        put(',', frame[i][2]);
        puts("]");
    }
    scenes = 0;
}

int main(void) {
    /* llvmpipe compiles a program for each combination of kinds of lights: minutes for 1000 scenes of up to 8 lights */
    setenv("GALLIUM_DRIVER", "softpipe", 0);
    OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 0, 0, 0, NULL);
    if (!context || !OSMesaMakeCurrent(context, frame, GL_FLOAT, SIDE, SIDE))
        fail("no frame of floats");
    fprintf(stderr, "%s, %s\n", glGetString(GL_VERSION), glGetString(GL_RENDERER));
    glEnable(GL_LIGHTING);
    glEnable(GL_NORMALIZE);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE);
    glClampColor(GL_CLAMP_VERTEX_COLOR, GL_FALSE);
    glClampColor(GL_CLAMP_FRAGMENT_COLOR, GL_FALSE);
    glDisable(GL_DITHER);

    char *line = NULL;
    size_t room = 0;
    if (getline(&line, &room, stdin) < 0 || strcmp(line, "{\"shading-laws\":1}\n") != 0)
        fail("this is not version 1 of the format");
    puts("{\"name\":\"Mesa's fixed-function OpenGL\",\"models\":[\"lambert\",\"blinn_phong\"],\"most_lights\":8}");
    fflush(stdout);
    while (getline(&line, &room, stdin) > 0) {
        const int end_of_batch = line[0] == '\n';
        if (!end_of_batch)
            draw(line);
        if (end_of_batch || scenes == SIDE * SIDE)
            answer();
        fflush(stdout);
    }
    free(line);
    OSMesaDestroyContext(context);
}
