    fn frag(&self, norm: &Self::VsOut) -> Self::Pixel {
        let seen = Vec3::from(self.mvp * Vec4::from(*norm)).normalized();
        let [n, l, seen] = [*norm, self.light_dir, seen].map(direction);
        let r = shading::reflection(seen, l);

        let ambient = 0.2;
        let diffuse = term::lambert(n, l) * 0.5;
        let specular = term::phong(r, UnitVec3::Z, 20);

        let light = ambient + diffuse + specular;
